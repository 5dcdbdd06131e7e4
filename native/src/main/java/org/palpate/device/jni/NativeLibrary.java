package org.palpate.device.jni;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Locale;

/**
 * Finds and loads the C++ device layer once. It takes the file that the system property {@value
 * #PROPERTY} names, else {@code palpate} on {@code java.library.path}, else the one in the jar. If
 * the property names a file that does not load, nothing else is tried.
 */
public final class NativeLibrary {
  /** The system property that names the library's file. */
  public static final String PROPERTY = "palpate.native";

  private static final NativeLibrary LOADED = load();

  private final String origin;

  /** The reason why the library was not loaded, in one line; empty if it was loaded. */
  final String loadFailure;

  private NativeLibrary(String origin, String loadFailure) {
    this.origin = origin;
    this.loadFailure = loadFailure;
  }

  /** Whether native methods can be called. */
  public static boolean isLoaded() {
    return LOADED.loadFailure.isEmpty();
  }

  /** Returns where the library came from; empty if it was not loaded. */
  public static String origin() {
    return LOADED.origin;
  }

  /** Makes one native call that does nothing: the least cost of a call, for benchmarks. */
  public static void callNothing() {
    NativeCalls.nothing();
  }

  /** Returns the reason why the library was not loaded and the remedy; empty if it was loaded. */
  public static String loadFailure() {
    return LOADED.loadFailure;
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

  /** Loads a file; if that fails, {@code remedy} ends the message. */
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
    file.toFile().deleteOnExit(); // files are deleted in the reverse order of registration
    Files.copy(bytes, file, StandardCopyOption.REPLACE_EXISTING);
    return file;
  }

  /** Returns the resource of the library for a platform, given by the JVM's names for it. */
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
