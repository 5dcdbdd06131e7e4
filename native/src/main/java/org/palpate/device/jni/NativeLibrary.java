package org.palpate.device.jni;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Locale;

/**
 * Finds and loads the C++ device layer, once: the file that the system property {@value #PROPERTY}
 * names, else {@code palpate} on {@code java.library.path}, else the one inside the jar. A property
 * that names a file which does not load is an error; nothing else is tried then.
 */
public final class NativeLibrary {
  /** The system property that names the library's file. */
  public static final String PROPERTY = "palpate.native";

  private static final NativeLibrary LOADED = load();

  private final String origin;

  /** One line: why it could not be loaded; empty where it was. */
  final String whyNot;

  private NativeLibrary(String origin, String whyNot) {
    this.origin = origin;
    this.whyNot = whyNot;
  }

  /** Whether native methods can be called. */
  public static boolean isLoaded() {
    return LOADED.whyNot.isEmpty();
  }

  /** Where the library came from; empty where it was not loaded. */
  public static String origin() {
    return LOADED.origin;
  }

  /** Calls native code that does nothing: the yardstick of what a crossing costs. */
  public static void callNothing() {
    NativeCalls.nothing();
  }

  /** One line: why it could not be loaded and what to do; empty where it was. */
  public static String whyNot() {
    return LOADED.whyNot;
  }

  private static NativeLibrary load() {
    String file = System.getProperty(PROPERTY);
    if (file != null && !file.isEmpty()) {
      return loadFile(Path.of(file).toAbsolutePath(), PROPERTY + "=" + file, "name the right one");
    }
    try {
      System.loadLibrary("palpate");
      return new NativeLibrary("java.library.path", "");
    } catch (UnsatisfiedLinkError notThere) {
      return loadFromJar();
    }
  }

  /** Loads a file; where it does not load, {@code remedy} ends the line that says so. */
  static NativeLibrary loadFile(Path file, String origin, String remedy) {
    try {
      System.load(file.toString());
      return new NativeLibrary(origin, "");
    } catch (UnsatisfiedLinkError e) {
      return new NativeLibrary(
          "", "cannot load the native library: " + origin + ": " + e.getMessage() + ": " + remedy);
    }
  }

  private static NativeLibrary loadFromJar() {
    String resource = resourceName(System.getProperty("os.name"), System.getProperty("os.arch"));
    try (InputStream bytes = NativeLibrary.class.getResourceAsStream(resource)) {
      if (bytes == null) {
        return new NativeLibrary(
            "",
            "no native library for this platform: "
                + resource
                + ": build it with cmake and a C++ compiler");
      }
      return loadFile(
          copyOut(bytes, resource),
          "jar:" + resource,
          "name a folder for programs with -Djava.io.tmpdir");
    } catch (IOException e) {
      return new NativeLibrary(
          "",
          "cannot unpack the native library: "
              + e.getMessage()
              + ": free or name a folder with -Djava.io.tmpdir");
    }
  }

  private static Path copyOut(InputStream bytes, String resource) throws IOException {
    Path folder = Files.createTempDirectory("palpate");
    Path file = folder.resolve(resource.substring(resource.lastIndexOf('/') + 1));
    folder.toFile().deleteOnExit();
    file.toFile().deleteOnExit(); // deleted first: the order is the reverse of registration
    Files.copy(bytes, file, StandardCopyOption.REPLACE_EXISTING);
    return file;
  }

  /** The resource that holds the library for a platform, by the names that the JVM gives it. */
  static String resourceName(String osName, String osArch) {
    String os = osName.toLowerCase(Locale.ROOT);
    String arch = osArch.toLowerCase(Locale.ROOT);
    String cpu =
        arch.equals("aarch64") || arch.equals("arm64")
            ? "aarch64"
            : arch.equals("amd64") ? "x86_64" : arch;
    if (os.startsWith("windows")) {
      return "/natives/windows-" + cpu + "/palpate.dll";
    }
    if (os.startsWith("mac")) {
      return "/natives/macos-" + cpu + "/libpalpate.dylib";
    }
    return "/natives/linux-" + cpu + "/libpalpate.so";
  }
}
