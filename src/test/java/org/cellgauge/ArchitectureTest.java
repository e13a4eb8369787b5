package org.cellgauge;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaMethodCall;
import com.tngtech.archunit.core.domain.Source;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What the modules and packages may know of each other, read from their class files. */
class ArchitectureTest {

    private static final String BASE = "org.cellgauge.";

    /** The path of a photo through the library: each package may use those before it. */
    private static final List<String> ORDER =
            List.of("warning", "geometry", "light", "cell", "settings", "vision", "pose", "estimate", "laplace",
                    "sampling", "placement", "posterior", "chains", "check", "output", "validation", "live", "overlay");

    /** Mathematics alone: uses no other package, and is used only by these. */
    private static final String STATISTICS = BASE + "statistics..";
    private static final List<String> USERS_OF_STATISTICS = List.of("sampling", "estimate", "placement",
            "chains", "check", "output", "validation", "overlay");

    private static final String[] BOOFCV = {"boofcv..", "georegression.."};
    private static final String RXJAVA = "io.reactivex..";

    private static final List<String> SHARED_POOL = List.of("parallel", "parallelStream", "parallelSort",
            "parallelSetAll", "parallelPrefix", "supplyAsync", "runAsync");

    private static final int JAVA_11_CLASS_FILE = 55;

    private static JavaClasses product;
    private static JavaClasses core;

    @BeforeAll
    static void readClassFiles() {
        Pattern testClasses = Pattern.compile(".*/classes/java/(test|jmh)/.*");
        ImportOption withoutTests = location -> !location.matches(testClasses);
        product = new ClassFileImporter().withImportOption(withoutTests).importPackages("org.cellgauge");
        core = product.that(new DescribedPredicate<>("in the module core") {
            @Override
            public boolean test(JavaClass type) {
                return type.getSource().map(Source::getUri)
                        .filter(uri -> uri.toString().matches(".*/core/build/(libs/core-|classes/java/main/).*"))
                        .isPresent();
            }
        });
    }

    /** Every rule below holds of nothing at all, so nothing would be noticed if the class files were not found. */
    @Test
    void allModulesAreSeen() {
        assertTrue(core.contain(BASE + "geometry.RigidTransform"), "classes of core were read");
        assertTrue(product.contain(BASE + "cli.Main"), "classes of desktop-cli were read");
        assertTrue(product.contain(BASE + "desktop.HtmlReport"), "classes of desktop were read");
        assertTrue(product.size() > core.size(), "core does not hold the command line");
        assertTrue(core.stream().noneMatch(type -> type.getPackageName().startsWith(BASE + "cli")
                || type.getPackageName().startsWith(BASE + "desktop")));
    }

    @Test
    void coreRunsOnJava11() throws IOException {
        List<String> tooNew = new ArrayList<>();
        for (JavaClass type : core) {
            URL file = type.getSource().orElseThrow().getUri().toURL();
            try (DataInputStream in = new DataInputStream(file.openStream())) {
                assertEquals(0xCAFEBABE, in.readInt(), type.getName());
                in.readUnsignedShort();
                int version = in.readUnsignedShort();
                if (version > JAVA_11_CLASS_FILE) {
                    tooNew.add(type.getName() + " has class file version " + version);
                }
            }
        }
        assertEquals(List.of(), tooNew);
    }

    @Test
    void coreKnowsNeitherDesktopNorAndroid() {
        noClasses().should().dependOnClassesThat()
                .resideInAnyPackage("java.awt..", "javax.swing..", "javax.imageio..", "android..", "androidx..")
                .check(core);
    }

    /** Remedies are data: whoever runs core, a tablet too, says how they are taken. */
    @Test
    void coreNamesNoOptionOfTheCommandLine() throws IOException {
        Pattern option = Pattern.compile("(?<![-\\w])--[a-z]");
        List<String> named = new ArrayList<>();
        int read = 0;
        Path sources = Path.of(System.getProperty("cellgauge.root", "."), "core/src/main/java");
        try (Stream<Path> files = Files.walk(sources)) {
            for (Path file : files.filter(f -> f.toString().endsWith(".java")).toList()) {
                read++;
                Files.readAllLines(file).stream().filter(line -> option.matcher(line).find())
                        .forEach(line -> named.add(file.getFileName() + ": " + line.trim()));
            }
        }
        assertTrue(read > 100, read + " files were read");
        assertEquals(List.of(), named);
    }

    /** A program without a command line can use the module desktop. */
    @Test
    void desktopKnowsNoCommandLine() {
        noClasses().that().resideInAPackage(BASE + "desktop..").should()
                .dependOnClassesThat().resideInAnyPackage("picocli..", BASE + "cli..")
                .check(product);
    }

    /** A package the order does not name would escape it. */
    @Test
    void everyPackageOfCoreHasItsPlaceInTheOrder() {
        List<String> known = new ArrayList<>(List.of("org.cellgauge", STATISTICS));
        ORDER.forEach(name -> known.add(BASE + name + ".."));
        classes().should().resideInAnyPackage(known.toArray(String[]::new)).check(core);
    }

    static List<String> order() {
        return ORDER;
    }

    @ParameterizedTest
    @MethodSource("order")
    void packageUsesOnlyThoseBeforeIt(String name) {
        List<String> allowed = new ArrayList<>();
        ORDER.subList(0, ORDER.indexOf(name) + 1).forEach(earlier -> allowed.add(BASE + earlier + ".."));
        if (USERS_OF_STATISTICS.contains(name)) {
            allowed.add(STATISTICS);
        }
        noClasses().that().resideInAPackage(BASE + name + "..").should()
                .dependOnClassesThat(resideInAPackage("org.cellgauge..")
                        .and(not(resideInAnyPackage(allowed.toArray(String[]::new)))))
                .allowEmptyShould(true).check(product);
    }

    @Test
    void statisticsIsMathematicsAlone() {
        noClasses().that().resideInAPackage(STATISTICS).should()
                .dependOnClassesThat(resideInAPackage("org.cellgauge..").and(not(resideInAPackage(STATISTICS))))
                .allowEmptyShould(true).check(product);
        noClasses().that().resideInAPackage(STATISTICS).should()
                .dependOnClassesThat()
                .resideInAnyPackage("boofcv..", "georegression..", "io.reactivex..", "com.google..")
                .allowEmptyShould(true).check(product);
    }

    @Test
    void geometryNeedsNothingButLinearAlgebra() {
        classes().that().resideInAPackage(BASE + "geometry..").should()
                .onlyDependOnClassesThat()
                .resideInAnyPackage("java..", "org.ejml..", "org.jspecify..", BASE + "geometry..")
                .check(core);
    }

    @Test
    void onlySamplingCheckAndLiveKnowStreams() {
        noClasses().that().resideOutsideOfPackages(BASE + "sampling..", BASE + "check..", BASE + "live..").should()
                .dependOnClassesThat().resideInAPackage(RXJAVA)
                .check(core);
    }

    @Test
    void onlyVisionAndPoseKnowBoofCv() {
        noClasses().that().resideOutsideOfPackages(BASE + "vision..", BASE + "pose..").should()
                .dependOnClassesThat().resideInAnyPackage(BOOFCV)
                .check(core);
    }

    /** The same input and seed must give the same figures, whatever ran before in the process. */
    @Test
    void nothingStaticIsMutable() {
        fields().that().areStatic().should().beFinal().check(product);
    }

    /** Who asks core for one thread gets one: the pool that a whole program shares is that program's. */
    @Test
    void coreUsesNoSharedPool() {
        noClasses().should().callMethodWhere(new DescribedPredicate<>("work is given to the common pool") {
            @Override
            public boolean test(JavaMethodCall call) {
                return SHARED_POOL.contains(call.getTarget().getName())
                        && call.getTargetOwner().getPackageName().startsWith("java.util");
            }
        }).check(core);
        noClasses().should().dependOnClassesThat().haveFullyQualifiedName("java.util.concurrent.ForkJoinPool")
                .check(core);
    }

    @Test
    void packagesFormNoCycles() {
        slices().matching("org.cellgauge.(*)..").should().beFreeOfCycles().check(product);
    }
}
