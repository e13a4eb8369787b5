package org.cellgauge.pack;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.function.ToLongFunction;

/** Lambdas and method references of all kinds, and what each of them gives; see {@link PlainLambdasTest}. */
public final class LambdaKinds implements Supplier<List<String>> {
    private final double factor = 2.5;
    private final List<String> results = new ArrayList<>();

    @Override
    public List<String> get() {
        captures();
        references();
        conversions();
        results.addAll(new Inner().get());
        results.add(Greeting.to("you").get());
        return results;
    }

    private void note(Object result) {
        results.add(String.valueOf(result));
    }

    private void captures() {
        boolean yes = true;
        byte b = 3;
        char c = 'c';
        short s = 5;
        int i = 7;
        long l = 11;
        float f = 13.5f;
        double d = 17.25;
        String text = "text";
        int[] array = {1, 2};
        Supplier<String> all = () -> yes + " " + b + c + s + i + l + f + d + text + array.length + factor;
        note(all.get());
        Runnable nothing = () -> note("ran");
        nothing.run();
        LongSupplier wide = () -> l + i;
        note(wide.getAsLong());
        DoubleUnaryOperator own = this::scaled;
        note(own.applyAsDouble(d));
        note(sameTwice());
    }

    /** Whether what captures nothing is one object. */
    private static boolean sameTwice() {
        List<Object> made = new ArrayList<>();
        for (int k = 0; k < 2; k++) {
            Runnable one = () -> { };
            made.add(one);
        }
        return made.get(0) == made.get(1);
    }

    private double scaled(double x) {
        return factor * x;
    }

    private void references() {
        Function<String, Integer> ofClass = Integer::valueOf;
        note(ofClass.apply("42"));
        Function<String, Integer> unbound = String::length;
        note(unbound.apply("four"));
        BiFunction<String, String, Boolean> ofTwo = String::startsWith;
        note(ofTwo.apply("start", "st"));
        Supplier<String> bound = "upper"::toUpperCase;
        note(bound.get());
        Function<CharSequence, Integer> ofInterface = CharSequence::length;
        note(ofInterface.apply("three"));
        Supplier<List<Integer>> constructor = ArrayList::new;
        note(constructor.get());
        Function<String, StringBuilder> constructorOfOne = StringBuilder::new;
        note(constructorOfOne.apply("built"));
        IntFunction<double[]> arrays = double[]::new;
        note(arrays.apply(3).length);
        Supplier<String> inherited = super::toString;
        note(inherited.get().startsWith(LambdaKinds.class.getName()));
        Runnable dropped = results::size;
        dropped.run();
        Runnable droppedWide = System::nanoTime;
        droppedWide.run();
        Function<Object[], List<Object>> variable = Arrays::asList;
        note(variable.apply(new Object[] {1, "two"}));
    }

    private void conversions() {
        ToDoubleFunction<Integer> unboxedAndWidened = x -> x;
        note(unboxedAndWidened.applyAsDouble(3));
        ToDoubleFunction<Integer> ofReference = Integer::intValue;
        note(ofReference.applyAsDouble(4));
        ToLongFunction<Short> shortToLong = Short::shortValue;
        note(shortToLong.applyAsLong((short) 9));
        IntToDoubleFunction widened = LambdaKinds::twice;
        note(widened.applyAsDouble(21));
        Function<Integer, Long> boxed = LambdaKinds::asLong;
        note(boxed.apply(8));
        Function<Integer, Double> boxedArgument = LambdaKinds::twice;
        note(boxedArgument.apply(5));
        IntPredicate odd = n -> n % 2 == 1;
        note(odd.test(3));
        Comparator<String> byLength = Comparator.comparingInt(String::length);
        note(byLength.compare("a", "bb"));
        Comparator<String> serializable = (Comparator<String> & Serializable) (x, y) -> y.compareTo(x);
        note(serializable.compare("a", "b"));
        Function<List<String>, String> generic = list -> list.get(0);
        note(generic.apply(List.of("first")));
        try {
            raw(generic);
        } catch (ClassCastException e) {
            note("refused");
        }
        BiFunction<Function<Integer, Integer>, Integer, Integer> nested = (g, n) -> g.apply(n) + 1;
        note(nested.apply(n -> n * 10, 4));
    }

    @SuppressWarnings({"unchecked", "rawtypes"})
    private static void raw(Function generic) {
        generic.apply("no list");
    }

    private static double twice(double x) {
        return 2 * x;
    }

    private static long asLong(int x) {
        return x;
    }

    /** Of a nest: its lambdas call what is private elsewhere in it. */
    private final class Inner implements Supplier<List<String>> {
        private final String name = "inner";

        @Override
        public List<String> get() {
            Function<Double, String> both = x -> name + scaled(x);
            return List.of(both.apply(2.0), new Deep().call().get());
        }

        /** Two levels down. */
        private final class Deep {
            Supplier<String> call() {
                return () -> "deep " + name + factor;
            }
        }
    }

    /** Lambdas of an interface, static ones and those of its private methods. */
    private interface Greeting extends Supplier<String> {
        static Greeting to(String whom) {
            return () -> "hello " + whom + " " + new Greeting() {
                @Override
                public String get() {
                    return "again";
                }
            }.twice().get();
        }

        /** Of a private method of the interface. */
        default Supplier<String> twice() {
            return () -> said() + get();
        }

        private String said() {
            Supplier<String> once = this::get;
            return once.get() + ", ";
        }
    }
}
