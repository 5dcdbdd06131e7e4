package org.palpate.platform;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;

/** Inspects the runnable jar: it carries the licence of everything that it holds. */
class RunnableJarTest {
  private static final Path JAR = Path.of("../target/palpate.jar");
  private static final String LICENCES = "META-INF/THIRD-PARTY-LICENCES.txt";

  /** The words that begin the licence of each library, by the start of its classes' names. */
  private static final Map<String, String> HEADINGS =
      Map.ofEntries(
          Map.entry("com/fasterxml/jackson/", "= jackson-core ="),
          Map.entry("com/github/jaiimageio/", "= jai-imageio-core ="),
          Map.entry("com/github/luben/zstd/", "= zstd-jni ="),
          Map.entry("com/jogamp/", "= JogAmp: JOGL, GlueGen and JOCL ="),
          Map.entry("com/sun/jna/", "= JNA ="),
          Map.entry("com/twelvemonkeys/", "= TwelveMonkeys ImageIO ="),
          Map.entry("ij/", "ImageJ 1 (ij)"),
          Map.entry("jj2000/", "= jai-imageio-jpeg2000 ="),
          Map.entry("jogamp/", "= JogAmp: JOGL, GlueGen and JOCL ="),
          Map.entry("joptsimple/", "This notice is provided with respect to JOpt Simple"),
          Map.entry("org/HdrHistogram/", "= HdrHistogram ="),
          Map.entry("org/apache/commons/codec/", "= commons-codec ="),
          Map.entry("org/apache/commons/compress/", "= commons-compress ="),
          Map.entry("org/apache/commons/io/", "= commons-io ="),
          Map.entry("org/apache/commons/lang3/", "= commons-lang3 ="),
          Map.entry("org/apache/commons/math3/", "= commons-math3 ="),
          Map.entry("org/hipparchus/", "= Hipparchus ="),
          Map.entry("org/knowm/xchart/", "XChart (Copyright"),
          Map.entry("org/openjdk/jmh/", "= JMH, with jopt-simple ="),
          Map.entry("picocli/", "picocli (Copyright"));

  @Test
  void carriesTheLicenceOfEveryLibraryInIt() throws IOException {
    String licences = PluginJars.text(jar(), LICENCES);
    Set<String> found = new TreeSet<>();
    Set<String> unknown = new TreeSet<>();
    for (String name : PluginJars.names(jar())) {
      if (name.endsWith(".class")) {
        String type = name.replaceFirst("^META-INF/versions/\\d+/", "");
        HEADINGS.keySet().stream()
            .filter(type::startsWith)
            .findFirst()
            .ifPresentOrElse(found::add, () -> unknown.add(type));
      }
    }
    unknown.removeIf(type -> type.startsWith("org/palpate/"));
    assertEquals(Set.of(), unknown, "classes of libraries whose licence is not known here");
    assertEquals(HEADINGS.keySet(), found, "libraries in the jar");
    for (String library : found) {
      String heading = HEADINGS.get(library);
      assertTrue(licences.contains(heading), () -> heading + " is not in " + LICENCES);
    }
  }

  /** The licence files of libraries overwrite each other, so none of them stands alone. */
  @Test
  void theLicenceInItIsThatOfPalpate() throws IOException {
    String licence = Files.readString(Path.of("../LICENSE"));
    assertEquals(licence, PluginJars.text(jar(), "META-INF/LICENSE"));
    List<String> others =
        PluginJars.names(jar()).stream()
            .filter(name -> name.matches("(META-INF/)?[^/]*(LICEN[CS]E|NOTICE|THIRD-PARTY)[^/]*"))
            .filter(name -> !name.equals("META-INF/LICENSE") && !name.equals(LICENCES))
            .toList();
    assertEquals(List.of(), others);
  }

  private static Path jar() {
    Assumptions.assumeTrue(
        Files.exists(JAR), "skipped: not packed yet, run mvn package: " + JAR.toAbsolutePath());
    return JAR;
  }
}
