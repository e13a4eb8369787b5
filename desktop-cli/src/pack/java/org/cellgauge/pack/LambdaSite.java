package org.cellgauge.pack;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * A place where a lambda or a method reference is made, and the class that does the same.
 *
 * <p>What the two have to agree in is what {@link java.lang.invoke.LambdaMetafactory} says: captured values become the
 * first arguments of the method behind, the others are taken from the interface's types to those of this very lambda
 * and on to the method's own, and its result the other way.
 */
final class LambdaSite {
    private static final String FACTORY = "of";
    private static final String ONLY = "ONLY";
    private static final String OBJECT = "java/lang/Object";
    /** Boxes of primitive types by their descriptor's letter. */
    private static final Map<String, String> BOXES = Map.of("Z", "java/lang/Boolean", "C", "java/lang/Character", "B",
            "java/lang/Byte", "S", "java/lang/Short", "I", "java/lang/Integer", "F", "java/lang/Float", "J",
            "java/lang/Long", "D", "java/lang/Double");
    /** Instructions that widen one primitive type to another, by the letters of both. */
    private static final Map<String, Integer> WIDENING = Map.of("IJ", Opcodes.I2L, "IF", Opcodes.I2F, "ID",
            Opcodes.I2D, "JF", Opcodes.L2F, "JD", Opcodes.L2D, "FD", Opcodes.F2D);
    private static final String SMALL_INTEGERS = "BCSI";

    private final String name;
    private final String method;
    private final String factory;
    private final Type[] captured;
    private final Type made;
    private final Type erased;
    private final Handle behind;
    private final Type own;

    /**
     * The place that an {@code invokedynamic} instruction of {@code LambdaMetafactory.metafactory} is.
     *
     * @param name of the class to make, with slashes
     * @param method of the interface, its name
     * @param factory descriptor of the instruction: from captured values to the interface
     * @param arguments of the bootstrap method: the interface's method as erased, the method behind, and the
     *     interface's method as this lambda has it
     */
    LambdaSite(String name, String method, String factory, Object... arguments) {
        this.name = name;
        this.method = method;
        this.factory = factory;
        this.captured = Type.getArgumentTypes(factory);
        this.made = Type.getReturnType(factory);
        this.erased = (Type) arguments[0];
        this.behind = (Handle) arguments[1];
        this.own = (Type) arguments[2];
    }

    /** Makes an instance by the class in place of the instruction: the stack is the same before and after. */
    void call(MethodVisitor code) {
        code.visitMethodInsn(Opcodes.INVOKESTATIC, name, FACTORY, factory, false);
    }

    /**
     * The class.
     *
     * @param version of class files, at least 55 (Java 11): with it nest mates may call each other's private methods
     * @param host of the nest it belongs to
     * @return its file
     * @throws IllegalStateException if a conversion is needed that no lambda of Java's compiler asks for
     */
    byte[] classFile(int version, String host) {
        ClassWriter out = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        out.visit(version, Opcodes.ACC_FINAL | Opcodes.ACC_SUPER | Opcodes.ACC_SYNTHETIC, name, null, OBJECT,
                new String[] {made.getInternalName()});
        out.visitNestHost(host);
        for (int i = 0; i < captured.length; i++) {
            out.visitField(Opcodes.ACC_PRIVATE | Opcodes.ACC_FINAL, field(i), captured[i].getDescriptor(), null, null)
                    .visitEnd();
        }
        constructor(out);
        if (captured.length == 0) {
            onlyInstance(out);
        } else {
            newInstances(out);
        }
        interfaceMethod(out);
        out.visitEnd();
        return out.toByteArray();
    }

    private static String field(int captured) {
        return "captured" + captured;
    }

    private void constructor(ClassWriter out) {
        MethodVisitor code = out.visitMethod(Opcodes.ACC_PRIVATE, "<init>",
                Type.getMethodDescriptor(Type.VOID_TYPE, captured), null, null);
        code.visitCode();
        code.visitVarInsn(Opcodes.ALOAD, 0);
        code.visitMethodInsn(Opcodes.INVOKESPECIAL, OBJECT, "<init>", "()V", false);
        int at = 1;
        for (int i = 0; i < captured.length; i++) {
            code.visitVarInsn(Opcodes.ALOAD, 0);
            code.visitVarInsn(captured[i].getOpcode(Opcodes.ILOAD), at);
            code.visitFieldInsn(Opcodes.PUTFIELD, name, field(i), captured[i].getDescriptor());
            at += captured[i].getSize();
        }
        end(code, Opcodes.RETURN);
    }

    private void construct(MethodVisitor code) {
        code.visitTypeInsn(Opcodes.NEW, name);
        code.visitInsn(Opcodes.DUP);
        int at = 0;
        for (Type each : captured) {
            code.visitVarInsn(each.getOpcode(Opcodes.ILOAD), at);
            at += each.getSize();
        }
        code.visitMethodInsn(Opcodes.INVOKESPECIAL, name, "<init>", Type.getMethodDescriptor(Type.VOID_TYPE, captured),
                false);
    }

    private void newInstances(ClassWriter out) {
        MethodVisitor code = out.visitMethod(Opcodes.ACC_STATIC, FACTORY, factory, null, null);
        code.visitCode();
        construct(code);
        end(code, Opcodes.ARETURN);
    }

    /** As Java does: what captures nothing is made once. */
    private void onlyInstance(ClassWriter out) {
        out.visitField(Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC | Opcodes.ACC_FINAL, ONLY, made.getDescriptor(), null,
                null).visitEnd();
        MethodVisitor start = out.visitMethod(Opcodes.ACC_STATIC, "<clinit>", "()V", null, null);
        start.visitCode();
        construct(start);
        start.visitFieldInsn(Opcodes.PUTSTATIC, name, ONLY, made.getDescriptor());
        end(start, Opcodes.RETURN);
        MethodVisitor code = out.visitMethod(Opcodes.ACC_STATIC, FACTORY, factory, null, null);
        code.visitCode();
        code.visitFieldInsn(Opcodes.GETSTATIC, name, ONLY, made.getDescriptor());
        end(code, Opcodes.ARETURN);
    }

    private void interfaceMethod(ClassWriter out) {
        MethodVisitor code = out.visitMethod(Opcodes.ACC_PUBLIC, method, erased.getDescriptor(), null, null);
        code.visitCode();
        boolean constructs = behind.getTag() == Opcodes.H_NEWINVOKESPECIAL;
        if (constructs) {
            code.visitTypeInsn(Opcodes.NEW, behind.getOwner());
            code.visitInsn(Opcodes.DUP);
        }
        List<Type> wanted = wanted();
        for (int i = 0; i < captured.length; i++) {
            code.visitVarInsn(Opcodes.ALOAD, 0);
            code.visitFieldInsn(Opcodes.GETFIELD, name, field(i), captured[i].getDescriptor());
        }
        Type[] given = erased.getArgumentTypes();
        Type[] typed = own.getArgumentTypes();
        int at = 1;
        for (int i = 0; i < given.length; i++) {
            code.visitVarInsn(given[i].getOpcode(Opcodes.ILOAD), at);
            at += given[i].getSize();
            convert(code, given[i], typed[i]);
            convert(code, typed[i], wanted.get(captured.length + i));
        }
        code.visitMethodInsn(instruction(), behind.getOwner(), behind.getName(), behind.getDesc(),
                behind.isInterface());
        Type result = constructs ? Type.getObjectType(behind.getOwner()) : Type.getReturnType(behind.getDesc());
        Type asked = erased.getReturnType();
        if (!asked.equals(Type.VOID_TYPE)) {
            convert(code, result, isPrimitive(asked) ? asked : own.getReturnType());
        } else if (result.getSize() > 0) {
            code.visitInsn(result.getSize() == 2 ? Opcodes.POP2 : Opcodes.POP);
        }
        end(code, asked.getOpcode(Opcodes.IRETURN));
    }

    private static void end(MethodVisitor code, int last) {
        code.visitInsn(last);
        code.visitMaxs(0, 0);
        code.visitEnd();
    }

    /** What the method behind takes, with the object it is called on. */
    private List<Type> wanted() {
        List<Type> wanted = new ArrayList<>();
        if (behind.getTag() != Opcodes.H_INVOKESTATIC && behind.getTag() != Opcodes.H_NEWINVOKESPECIAL) {
            wanted.add(Type.getObjectType(behind.getOwner()));
        }
        wanted.addAll(List.of(Type.getArgumentTypes(behind.getDesc())));
        return wanted;
    }

    /** Private methods of the nest are called like others from Java 11 on. */
    private int instruction() {
        switch (behind.getTag()) {
            case Opcodes.H_INVOKESTATIC: return Opcodes.INVOKESTATIC;
            case Opcodes.H_NEWINVOKESPECIAL: return Opcodes.INVOKESPECIAL;
            default: return behind.isInterface() ? Opcodes.INVOKEINTERFACE : Opcodes.INVOKEVIRTUAL;
        }
    }

    private static String box(Type primitive) {
        return BOXES.get(primitive.getDescriptor());
    }

    private static boolean isPrimitive(Type type) {
        return type.getSort() < Type.ARRAY;
    }

    private static void convert(MethodVisitor code, Type from, Type to) {
        if (from.equals(to)) {
            return;
        }
        if (isPrimitive(from) && isPrimitive(to)) {
            widen(code, from, to);
        } else if (isPrimitive(from)) {
            String box = box(from);
            code.visitMethodInsn(Opcodes.INVOKESTATIC, box, "valueOf", "(" + from.getDescriptor() + ")L" + box + ";",
                    false);
        } else if (isPrimitive(to)) {
            unbox(code, from, to);
        } else if (!to.getInternalName().equals(OBJECT)) {
            code.visitTypeInsn(Opcodes.CHECKCAST, to.getInternalName());
        }
    }

    private static void unbox(MethodVisitor code, Type from, Type to) {
        Type value = to;
        for (Map.Entry<String, String> box : BOXES.entrySet()) {
            if (box.getValue().equals(from.getInternalName())) {
                value = Type.getType(box.getKey());
            }
        }
        String box = box(value);
        if (!box.equals(from.getInternalName())) {
            code.visitTypeInsn(Opcodes.CHECKCAST, box);
        }
        code.visitMethodInsn(Opcodes.INVOKEVIRTUAL, box, value.getClassName() + "Value", "()" + value.getDescriptor(),
                false);
        if (!value.equals(to)) {
            widen(code, value, to);
        }
    }

    private static void widen(MethodVisitor code, Type from, Type to) {
        if (SMALL_INTEGERS.contains(from.getDescriptor()) && to.equals(Type.INT_TYPE)) {
            return;
        }
        String small = SMALL_INTEGERS.contains(from.getDescriptor()) ? "I" : from.getDescriptor();
        Integer instruction = WIDENING.get(small + to.getDescriptor());
        if (instruction == null) {
            throw new IllegalStateException("no way from " + from + " to " + to);
        }
        code.visitInsn(instruction);
    }
}
