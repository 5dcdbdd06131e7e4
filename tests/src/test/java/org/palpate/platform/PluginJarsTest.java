package org.palpate.platform;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Inspects both jars that people install. */
class PluginJarsTest {
  private static final List<String> JOGAMP_NATIVES =
      List.of(
          "natives/linux-amd64/libjogl_desktop.so",
          "natives/linux-amd64/libgluegen_rt.so",
          "natives/linux-amd64/libnewt_head.so",
          "natives/linux-aarch64/libjogl_desktop.so",
          "natives/windows-amd64/jogl_desktop.dll",
          "natives/windows-amd64/gluegen_rt.dll",
          "natives/macosx-universal/libjogl_desktop.dylib",
          "natives/macosx-universal/libgluegen_rt.dylib");

  private static final List<String> JNA_NATIVES =
      List.of(
          "com/sun/jna/linux-x86-64/libjnidispatch.so",
          "com/sun/jna/linux-aarch64/libjnidispatch.so",
          "com/sun/jna/win32-x86-64/jnidispatch.dll",
          "com/sun/jna/darwin-aarch64/libjnidispatch.jnilib",
          "com/sun/jna/darwin-x86-64/libjnidispatch.jnilib");

  /** The classes that need JOCL. Commands load them on request, and the plug-in never does. */
  private static final String NEED_JOCL = "org/palpate/opencl/Jocl";

  @Test
  void theThinJarHasNoNameThatFijiHasToo() throws IOException {
    Set<String> roots = roots(PluginJars.thin());
    assertEquals(Set.of("META-INF", "natives", "org/palpate", "plugins.config"), roots);
  }

  @Test
  void theBundleAddsJoglGluegenAndJnaUnderTheirOwnNames() throws IOException {
    Set<String> roots = roots(PluginJars.bundle());
    roots.removeAll(roots(PluginJars.thin()));
    roots.removeIf(name -> name.startsWith("com/jogamp") || name.startsWith("jogamp/"));
    roots.removeIf(name -> name.startsWith("newt/") || name.startsWith("gluegen"));
    assertEquals(Set.of("com/sun"), roots);
    Set<String> names = PluginJars.names(PluginJars.bundle());
    assertTrue(names.containsAll(JOGAMP_NATIVES), () -> missing(JOGAMP_NATIVES, names));
    assertTrue(names.containsAll(JNA_NATIVES), () -> missing(JNA_NATIVES, names));
    assertTrue(names.contains("com/jogamp/opengl/GL.class"));
    assertTrue(names.contains("com/sun/jna/Native.class"));
  }

  private static String missing(List<String> wanted, Set<String> names) {
    return "missing: " + wanted.stream().filter(name -> !names.contains(name)).toList();
  }

  /** Returns the first two folders of every file, or the file if it has none. */
  private static Set<String> roots(Path jar) throws IOException {
    return PluginJars.names(jar).stream()
        .map(PluginJarsTest::root)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static String root(String name) {
    String[] parts = name.split("/", -1);
    boolean shallow = parts.length < 3 || parts[0].equals("META-INF") || parts[0].equals("natives");
    return shallow ? parts[0] : parts[0] + "/" + parts[1];
  }

  @Test
  void neitherJarHasForeignServicesOrImagejItself() throws IOException {
    for (Path jar : List.of(PluginJars.thin(), PluginJars.bundle())) {
      Set<String> names = PluginJars.names(jar);
      List<String> foreign =
          names.stream()
              .filter(
                  name ->
                      name.startsWith("META-INF/services/")
                          || name.startsWith("ij/")
                          || name.startsWith("org/scijava/")
                          || name.endsWith("module-info.class")
                          || name.contains("libraries/jogamp")
                          || name.contains("libraries/jna"))
              .toList();
      assertEquals(List.of(), foreign, jar.toString());
    }
  }

  @Test
  void everyCommandOfTheMenuIsAClassOfTheJar() throws IOException {
    for (Path jar : List.of(PluginJars.thin(), PluginJars.bundle())) {
      Set<String> names = PluginJars.names(jar);
      List<String> commands =
          PluginJars.text(jar, "plugins.config")
              .lines()
              .filter(line -> line.startsWith("Plugins>Palpate") && line.contains("org."))
              .map(line -> line.substring(line.lastIndexOf(' ') + 1))
              .toList();
      assertEquals(11, commands.size());
      for (String command : commands) {
        assertTrue(names.contains(command.replace('.', '/') + ".class"), command);
      }
      assertTrue(
          PluginJars.text(jar, "META-INF/json/org.scijava.plugin.Plugin")
              .contains("\"class\":\"org.palpate.scijava.ReplayFile\""));
    }
  }

  @Test
  void thePartsListNamesEveryLibraryWithVersionAndLicence() throws IOException {
    String parts = PluginJars.text(PluginJars.bundle(), "META-INF/sbom/palpate.cdx.json");
    assertTrue(parts.contains("\"bomFormat\" : \"CycloneDX\""));
    for (String part :
        List.of(
            "org.jogamp.jogl/jogl-all@2.6.0",
            "org.jogamp.gluegen/gluegen-rt@2.6.0",
            "net.java.dev.jna/jna@5.14.0",
            "org.hdrhistogram/HdrHistogram@2.2.2",
            "info.picocli/picocli@",
            "com.fasterxml.jackson.core/jackson-core@",
            "org.apache.commons/commons-compress@",
            "com.github.jai-imageio/jai-imageio-jpeg2000@",
            "com.twelvemonkeys.imageio/imageio-jpeg@")) {
      assertTrue(parts.contains("pkg:maven/" + part), part);
    }
    assertTrue(parts.contains("\"id\" : \"Apache-2.0\""));
    for (Path jar : ClassPath.jars("picocli", "jackson-core", "commons-compress", "imageio-jpeg")) {
      String file = jar.getFileName().toString();
      String artifact = file.replaceFirst("-([0-9][^-]*)\\.jar$", "@$1");
      assertTrue(parts.contains("/" + artifact + "?"), artifact);
    }
    assertEquals(
        parts, PluginJars.text(PluginJars.thin(), "META-INF/sbom/palpate.cdx.json"), "thin");
  }

  @Test
  void theJarsContainLicencesAndVersion() throws IOException {
    for (Path jar : List.of(PluginJars.thin(), PluginJars.bundle())) {
      assertTrue(PluginJars.text(jar, "META-INF/LICENSE").contains("Apache License"));
      String licences = PluginJars.text(jar, "META-INF/THIRD-PARTY-LICENCES.txt");
      for (String holder :
          List.of("JogAmp Community", "Harald Kuhr", "Sun Microsystems", "HdrHistogram", "JNA")) {
        assertTrue(licences.contains(holder), holder);
      }
      try (JarFile file = new JarFile(jar.toFile())) {
        Attributes manifest = file.getManifest().getMainAttributes();
        assertEquals("Palpate", manifest.getValue(Attributes.Name.IMPLEMENTATION_TITLE));
        assertTrue(manifest.getValue(Attributes.Name.IMPLEMENTATION_VERSION).matches("\\d.*"));
      }
    }
  }

  @Test
  void theUpdateSiteHasTheThinJarInFijisFolder() throws IOException {
    Path thin = PluginJars.thin();
    try (Stream<Path> files = Files.walk(PluginJars.updateSite())) {
      List<String> relative =
          files
              .filter(Files::isRegularFile)
              .map(file -> PluginJars.updateSite().relativize(file).toString())
              .toList();
      assertEquals(List.of(Path.of("plugins", "Palpate_.jar").toString()), relative);
    }
    assertArrayEquals(
        Files.readAllBytes(thin),
        Files.readAllBytes(PluginJars.updateSite().resolve("plugins/Palpate_.jar")));
  }

  /** Libraries were moved to packages of their own, and every class must still find its own. */
  @Test
  void everyClassOfTheThinJarLoadsBesideFijisLibraries() throws Exception {
    Path thin = PluginJars.thin();
    List<URL> urls = new ArrayList<>(List.of(thin.toUri().toURL()));
    for (Path library : ClassPath.jars("jogl-all", "gluegen-rt", "jna", "ij", "scijava-common")) {
      urls.add(library.toUri().toURL());
    }
    List<String> failures = new ArrayList<>();
    long members = 0;
    try (URLClassLoader loader =
        new URLClassLoader(urls.toArray(URL[]::new), ClassLoader.getPlatformClassLoader())) {
      for (String name : PluginJars.names(thin)) {
        if (name.startsWith("org/palpate/")
            && name.endsWith(".class")
            && !name.startsWith("org/palpate/libraries/")
            && !name.startsWith(NEED_JOCL)) {
          members += members(loader, name, failures);
        }
      }
    }
    assertEquals(List.of(), failures);
    assertTrue(members > 1000, "members: " + members);
  }

  /** Counts the methods and fields of a class, which resolves their types. */
  private static int members(ClassLoader loader, String name, List<String> failures) {
    String type = name.substring(0, name.length() - ".class".length()).replace('/', '.');
    try {
      Class<?> loaded = Class.forName(type, false, loader);
      return loaded.getDeclaredMethods().length + loaded.getDeclaredFields().length;
    } catch (ClassNotFoundException | LinkageError e) {
      failures.add(type + ": " + e);
      return 0;
    }
  }
}
