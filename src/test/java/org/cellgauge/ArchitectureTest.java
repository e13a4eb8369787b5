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
import com.tngtech.archunit.core.domain.JavaPackage;
import com.tngtech.archunit.core.domain.Source;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.cellgauge.fuzz.Target;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What the modules and packages may know of each other, read from their class files. */
class ArchitectureTest {

    private static final String BASE = "org.cellgauge.";

    /**
     * The path of a photo through the library: each package may use those before it. What is not for users stands in
     * {@code internal}, in a package of the same name and at the same place of the path.
     */
    private static final List<String> ORDER =
            List.of("warning", "geometry", "light", "cell", "settings", "vision", "calibration", "pose", "estimate",
                    "laplace", "plan", "sampling", "placement", "posterior", "chains", "check", "output", "survey",
                    "validation", "live", "overlay");

    /** Mathematics alone: uses no other package, and is used only by these. */
    private static final List<String> STATISTICS = room("statistics");
    private static final List<String> USERS_OF_STATISTICS = List.of("sampling", "estimate", "placement",
            "chains", "check", "output", "survey", "validation", "overlay");

    private static final Pattern ROOM = Pattern.compile("^org\\.cellgauge\\.(?:internal\\.)?(\\w+)\\.");

    private static final String[] BOOFCV = {"boofcv..", "georegression.."};
    private static final String RXJAVA = "io.reactivex..";

    private static final List<String> SHARED_POOL = List.of("parallel", "parallelStream", "parallelSort",
            "parallelSetAll", "parallelPrefix", "supplyAsync", "runAsync");

    private static final int JAVA_17_CLASS_FILE = 61;

    /** Calls that only a reader of files needs. */
    private static final String READING = String.join("|", "java\\.nio\\.file\\.Files\\."
            + "(readAll.*|readString|newInputStream|newByteChannel|newBufferedReader|lines)",
            "java\\.io\\.File(InputStream|Reader)\\.<init>",
            "com\\.google\\.gson\\.(JsonParser|stream\\.JsonReader)\\..*",
            "javax\\.imageio\\.ImageIO\\.getImageReaders.*",
            "org\\.yaml\\.snakeyaml\\.reader\\.StreamReader\\.<init>",
            "org\\.cellgauge\\.cell\\.(YamlValue|OpenCvXml)\\.parse",
            "org\\.cellgauge\\.internal\\.cell\\.InputFiles\\.(text|bytes)");
    /**
     * Hand on what others take apart: the bytes of any file, values of any YAML, standard input, what a cell's hash is
     * of; a picture that was just made. A table of numbers that {@code validate} goes on with, which it wrote. And of
     * earlier runs one number at the head of a file of draws, and figures that are made again where they are damaged.
     */
    private static final List<String> NO_READERS = List.of("internal.cell.InputFiles", "cell.YamlValue",
            "cli.StandardInput", "desktop.CellFile", "desktop.EarlierResults", "desktop.render.GreyJpeg",
            "cli.CoverageStudyRun", "desktop.reproduce.KeptFigures");

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
    void coreRunsOnJava17() throws IOException {
        List<String> tooNew = new ArrayList<>();
        for (JavaClass type : core) {
            URL file = type.getSource().orElseThrow().getUri().toURL();
            try (DataInputStream in = new DataInputStream(file.openStream())) {
                assertEquals(0xCAFEBABE, in.readInt(), type.getName());
                in.readUnsignedShort();
                int version = in.readUnsignedShort();
                if (version > JAVA_17_CLASS_FILE) {
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

    /** What takes a file apart gets mutated ones as well (docs/robustness.md), or says here why it need not. */
    @Test
    void everyReaderIsTriedOnMutatedInputs() {
        Set<String> readers = new TreeSet<>();
        for (JavaClass type : product) {
            boolean reads = type.getCodeUnitCallsFromSelf().stream().anyMatch(call -> {
                String owner = call.getTargetOwner().getName();
                return (owner + "." + call.getName()).matches(READING) && !owner.equals(type.getName());
            });
            if (reads) {
                readers.add(type.getName().substring(BASE.length()).replaceFirst("\\$.*", ""));
            }
        }
        Set<String> tried = new TreeSet<>(NO_READERS);
        for (Target target : Target.values()) {
            tried.addAll(target.readers());
        }
        assertEquals(tried, readers);
    }

    /** NullAway looks at packages that are marked, and at no others. */
    @Test
    void everyPackageOfCoreSaysWhatMayBeNull() {
        List<String> unmarked = core.stream().map(JavaClass::getPackage)
                .filter(name -> !name.isAnnotatedWith("org.jspecify.annotations.NullMarked"))
                .map(JavaPackage::getName).distinct().sorted().toList();
        assertEquals(List.of(), unmarked);
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
        List<String> known = new ArrayList<>(List.of("org.cellgauge"));
        known.addAll(STATISTICS);
        ORDER.forEach(name -> known.addAll(room(name)));
        classes().should().resideInAnyPackage(array(known)).check(core);
    }

    /** The patterns of packages and of their internal parts. */
    private static List<String> room(String... names) {
        return Stream.of(names)
                .flatMap(name -> Stream.of(BASE + name + "..", BASE + "internal." + name + "..")).toList();
    }

    private static String[] array(List<String> packages) {
        return packages.toArray(String[]::new);
    }

    static List<String> order() {
        return ORDER;
    }

    @ParameterizedTest
    @MethodSource("order")
    void packageUsesOnlyThoseBeforeIt(String name) {
        List<String> allowed = new ArrayList<>();
        ORDER.subList(0, ORDER.indexOf(name) + 1).forEach(earlier -> allowed.addAll(room(earlier)));
        if (USERS_OF_STATISTICS.contains(name)) {
            allowed.addAll(STATISTICS);
        }
        noClasses().that().resideInAnyPackage(array(room(name))).should()
                .dependOnClassesThat(resideInAPackage("org.cellgauge..")
                        .and(not(resideInAnyPackage(array(allowed)))))
                .allowEmptyShould(true).check(product);
    }

    @Test
    void statisticsIsMathematicsAlone() {
        noClasses().that().resideInAnyPackage(array(STATISTICS)).should()
                .dependOnClassesThat(resideInAPackage("org.cellgauge..")
                        .and(not(resideInAnyPackage(array(STATISTICS)))))
                .allowEmptyShould(true).check(product);
        noClasses().that().resideInAnyPackage(array(STATISTICS)).should()
                .dependOnClassesThat()
                .resideInAnyPackage("boofcv..", "georegression..", "io.reactivex..", "com.google..")
                .allowEmptyShould(true).check(product);
    }

    @Test
    void geometryNeedsNothingButLinearAlgebra() {
        classes().that().resideInAnyPackage(array(room("geometry"))).should()
                .onlyDependOnClassesThat()
                .resideInAnyPackage("java..", "org.ejml..", "org.jspecify..", BASE + "geometry..",
                        BASE + "internal.geometry..")
                .check(core);
    }

    @Test
    void onlySamplingCheckSurveyAndLiveKnowStreams() {
        noClasses().that().resideOutsideOfPackages(array(room("sampling", "check", "survey", "live"))).should()
                .dependOnClassesThat().resideInAPackage(RXJAVA)
                .check(core);
    }

    @Test
    void onlyVisionAndPoseKnowBoofCv() {
        noClasses().that().resideOutsideOfPackages(array(room("vision", "pose"))).should()
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
        slices().assignedFrom(new SliceAssignment() {
            @Override
            public SliceIdentifier getIdentifierOf(JavaClass type) {
                Matcher room = ROOM.matcher(type.getPackageName() + ".");
                return room.find() ? SliceIdentifier.of(room.group(1)) : SliceIdentifier.ignore();
            }

            @Override
            public String getDescription() {
                return "packages with their internal part";
            }
        }).should().beFreeOfCycles().check(product);
    }
}
