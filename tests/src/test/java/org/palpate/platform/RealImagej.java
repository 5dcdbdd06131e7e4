package org.palpate.platform;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A real ImageJ in a folder and a process of its own, with the plug-in installed as people install
 * it and a probe that acts and observes.
 */
final class RealImagej {
  private static final long PATIENCE_SECONDS = 400;

  private final Path folder;
  private final List<Path> classPath = new ArrayList<>();
  private Path javaHome = Path.of(System.getProperty("java.home"));
  private final Map<String, String> properties = new LinkedHashMap<>();

  /** The observations of the probe: facts by name, and the standard error. */
  record Seen(Map<String, String> facts, String errors) {
    String of(String name) {
      assertTrue(facts.containsKey(name), () -> "no fact " + name + " in " + facts + errors);
      return facts.get(name);
    }

    long number(String name) {
      return Long.parseLong(of(name));
    }
  }

  private RealImagej(Path folder, Path plugin, Path imagej) throws IOException {
    this.folder = folder;
    Path plugins = Files.createDirectories(folder.resolve("plugins"));
    Files.copy(plugin, plugins.resolve(plugin.getFileName()), StandardCopyOption.REPLACE_EXISTING);
    putProbe(plugins.resolve("Probe_.jar"));
    classPath.add(imagej);
  }

  /** Returns plain ImageJ with only the bundle in its plug-ins folder. */
  static RealImagej plain(Path folder) throws IOException {
    return new RealImagej(folder, PluginJars.bundle(), ClassPath.jars("ij").get(0));
  }

  /** Returns another build of ImageJ, such as Debian's, with the bundle. */
  static RealImagej plain(Path folder, Path imagej) throws IOException {
    return new RealImagej(folder, PluginJars.bundle(), imagej);
  }

  /** Returns one flat class path as in Fiji, with its libraries and the thin jar. */
  static RealImagej flat(Path folder) throws IOException {
    RealImagej imagej = new RealImagej(folder, PluginJars.thin(), ClassPath.jars("ij").get(0));
    imagej.classPath.add(PluginJars.thin());
    imagej.classPath.addAll(ClassPath.jars("jna", "scijava-common"));
    imagej.classPath.addAll(ClassPath.jogamp());
    return imagej;
  }

  /** Chooses another JDK. */
  RealImagej on(Path otherJavaHome) {
    javaHome = otherJavaHome;
    return this;
  }

  /** Sets a property of the probe. */
  RealImagej with(String property, Object value) {
    properties.put(property, value.toString());
    return this;
  }

  private static void putProbe(Path jar) throws IOException {
    try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
      put(out, "plugins.config", "Plugins, \"Probe\", " + ImagejProbe.class.getName() + "\n");
      Path classes = classesFolder();
      Path own = Path.of(ImagejProbe.class.getName().replace('.', '/')).getParent();
      try (Stream<Path> files = Files.list(classes.resolve(own))) {
        for (Path file : files.toList()) {
          String name = file.getFileName().toString();
          if (name.startsWith("ImagejProbe")) {
            out.putNextEntry(new JarEntry(own.resolve(name).toString().replace('\\', '/')));
            Files.copy(file, out);
          }
        }
      }
    }
  }

  private static void put(JarOutputStream out, String name, String text) throws IOException {
    out.putNextEntry(new JarEntry(name));
    out.write(text.getBytes(StandardCharsets.UTF_8));
  }

  private static Path classesFolder() {
    try {
      return Path.of(ImagejProbe.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    } catch (java.net.URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * Starts ImageJ, runs parts of the probe, and waits for the end.
   *
   * @param parts the names of the parts
   */
  Seen play(XServer display, String... parts) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(javaHome.resolve("bin").resolve("java").toString());
    command.add("-Xmx1g");
    command.add("-Duser.home=" + folder);
    command.add("-Dplugins.dir=" + folder);
    command.add("-Dprobe.dir=" + folder);
    command.add("-Dprobe.parts=" + String.join(",", parts));
    properties.forEach((name, value) -> command.add("-D" + name + "=" + value));
    String path =
        classPath.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
    command.addAll(List.of("-cp", path, "ij.ImageJ", "-port0", "-run", "Probe"));
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().put("DISPLAY", display.display());
    builder.redirectError(folder.resolve("stderr.txt").toFile());
    builder.redirectOutput(folder.resolve("stdout.txt").toFile());
    Process process = builder.start();
    boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
    if (!ended) {
      dumpThreads(process);
      process.destroyForcibly();
    }
    String errors = Files.readString(folder.resolve("stderr.txt"));
    assertTrue(ended, () -> "ImageJ did not end; standard error: " + errors);
    return new Seen(facts(), errors);
  }

  /** Requests a thread dump, which the JVM prints on its standard output. */
  private static void dumpThreads(Process process) throws IOException, InterruptedException {
    new ProcessBuilder("kill", "-QUIT", Long.toString(process.pid())).start().waitFor();
    process.waitFor(2, TimeUnit.SECONDS);
  }

  private Map<String, String> facts() throws IOException {
    Map<String, String> facts = new LinkedHashMap<>();
    Path file = folder.resolve("facts.txt");
    if (Files.exists(file)) {
      for (String line : Files.readAllLines(file)) {
        int equals = line.indexOf('=');
        facts.put(line.substring(0, equals), line.substring(equals + 1).replace("\\n", "\n"));
      }
    }
    return facts;
  }
}
