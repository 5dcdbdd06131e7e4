package org.palpate.endtoend;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.imageio.ImageIO;

/**
 * Runs a fixed set of commands and returns the SHA-256 of what each of them writes: replays with
 * every solver on every phantom, surfaces, exported volumes, and the numbers in reports.
 *
 * <p>A change that is meant to keep the behaviour keeps every checksum. The inputs are made from
 * seeds, so the checksums are the same on every machine and JDK. Pictures depend on the OpenGL
 * driver; they are compared only between two builds on one machine.
 */
final class RecordedBehaviour {
  private static final String[] SOLVERS = {"dot", "paper", "guarded", "smooth", "none"};
  private static final String[] PHANTOMS = {
    "head:96", "sphere:64", "shell:64", "plane:64", "torus:64", "maze:48"
  };
  private static final int FRAMES = 600;

  /** Keys of a report that depend on time, on the machine or on the wording alone. */
  private static final String NOT_COMPARED =
      ".*/(java|version|ns_per_frame|command|volume|file|memory[a-z_]*|note|seconds|surface_ms|first_picture_s|message)(/.*)?";

  private final Path folder;
  private final Map<String, String> checksums = new TreeMap<>();

  private RecordedBehaviour(Path folder) {
    this.folder = folder;
  }

  /** Returns name to checksum for everything that needs no scan and no display. */
  static Map<String, String> ofPhantoms(Path folder) throws IOException {
    RecordedBehaviour recorded = new RecordedBehaviour(folder);
    recorded.replayPhantoms();
    recorded.replayOptions();
    recorded.writeSurfacesAndVolumes();
    return recorded.checksums;
  }

  /** Returns name to checksum for the scans in {@code data}. */
  static Map<String, String> ofScans(Path folder, Path data) throws IOException {
    RecordedBehaviour recorded = new RecordedBehaviour(folder);
    recorded.replayScans(data);
    return recorded.checksums;
  }

  /** Returns name to checksum of the pixels of pictures without their captions. */
  static Map<String, String> ofPictures(Path folder) throws IOException {
    RecordedBehaviour recorded = new RecordedBehaviour(folder);
    recorded.drawPictures();
    return recorded.checksums;
  }

  /** Writes the checksums of everything, to compare two builds on one machine: FOLDER DATA FILE. */
  public static void main(String[] arguments) throws IOException {
    Path folder = Files.createDirectories(Path.of(arguments[0]));
    Map<String, String> all = new TreeMap<>(ofPhantoms(folder));
    all.putAll(ofScans(folder, Path.of(arguments[1])));
    all.putAll(ofPictures(folder));
    Files.writeString(Path.of(arguments[2]), text(all));
  }

  /** Returns the checksums as lines {@code SHA256 NAME}. */
  static String text(Map<String, String> checksums) {
    StringBuilder lines = new StringBuilder();
    checksums.forEach((name, sum) -> lines.append(sum).append("  ").append(name).append('\n'));
    return lines.toString();
  }

  private void replayPhantoms() throws IOException {
    for (String phantom : PHANTOMS) {
      int edge = Integer.parseInt(phantom.substring(phantom.indexOf(':') + 1));
      Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), FRAMES, edge, 20130701);
      for (String solver : SOLVERS) {
        replay(
            phantom + " " + solver,
            trajectory,
            "--phantom",
            phantom,
            "--coordinates",
            "grid",
            "--solver",
            solver);
      }
    }
  }

  private void replayOptions() throws IOException {
    Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), FRAMES, 64, 7);
    String[][] variants = {
      {"smooth grey", "--phantom", "sphere:64:grey", "--segment", "ball=>=500"},
      {
        "smooth bits",
        "--phantom",
        "sphere:64:grey",
        "--segment",
        "b=>=500",
        "--smooth-from",
        "bits"
      },
      {"range of grey", "--phantom", "torus:64:grey", "--segment", "b=300..900"},
      {"friction none", "--phantom", "torus:64", "--friction", "0"},
      {"friction shorter", "--phantom", "torus:64", "--friction-form", "shorter"},
      {"friction cone", "--phantom", "torus:64", "--friction-form", "cone", "--solver", "guarded"},
      {"short step", "--phantom", "torus:64", "--max-step", "0.7", "--solver", "guarded"},
      {"long step", "--phantom", "torus:64", "--max-step", "60"},
      {"limited", "--phantom", "sphere:64", "--max-force", "0.75"},
      {"stiff", "--phantom", "shell:64", "--stiffness", "1.7"},
      {"gridplanes", "--phantom", "sphere:64", "--solver", "paper", "--collision", "gridplanes"},
      {"sampled", "--phantom", "sphere:64", "--solver", "dot", "--collision", "sampled:0.3"},
      {"exact", "--phantom", "sphere:64", "--solver", "paper", "--collision", "exact"},
      {"bare sampled", "--phantom", "sphere:64", "--solver", "none", "--collision", "sampled:0.5"},
    };
    for (String[] variant : variants) {
      replay(variant[0], trajectory, Stream.of(variant).skip(1).toArray());
    }
    replay(
        "materials",
        TestFiles.trajectory(folder.resolve("t.csv"), FRAMES, 96, 11),
        "--phantom",
        "head:96",
        "--material",
        "skull=stiffness:0.8,friction:0.1",
        "--material",
        "skin=stiffness:0.2,friction:0.4,damping:0.001",
        "--friction-form",
        "cone");
    replay("raw device", faultyTrajectory(), "--phantom", "sphere:64", "--raw-device");
  }

  /** A trajectory with NaN, infinities, repeated and backward times. */
  private Path faultyTrajectory() throws IOException {
    List<String> lines =
        new ArrayList<>(
            Files.readAllLines(TestFiles.trajectory(folder.resolve("t.csv"), FRAMES, 64, 3)));
    for (int n = 20; n < lines.size(); n += 37) {
      String[] row = lines.get(n).split(",");
      row[n % 4] = n % 4 == 0 ? "5" : n % 3 == 0 ? "NaN" : "-Infinity";
      lines.set(n, String.join(",", row));
    }
    return Files.write(folder.resolve("faulty.csv"), lines);
  }

  private void replayScans(Path data) throws IOException {
    Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), FRAMES, 200, 23);
    Path head = data.resolve("CThead/CThead_u16gz.nrrd");
    for (String solver : SOLVERS) {
      replay(
          "CThead " + solver,
          trajectory,
          "--volume",
          head,
          "--segment",
          "bone=>=1500",
          "--solver",
          solver,
          "--coordinates",
          "grid");
    }
    replay(
        "CThead bits",
        trajectory,
        "--volume",
        head,
        "--segment",
        "bone=>=1500",
        "--smooth-from",
        "bits");
    replay(
        "atlas",
        trajectory,
        "--volume",
        data.resolve("labels/HN-Atlas-labels.nrrd"),
        "--coordinates",
        "grid");
    replay(
        "totalseg",
        TestFiles.trajectory(folder.resolve("t.csv"), FRAMES, 100, 29),
        "--volume",
        data.resolve("totalseg/example_seg_fast_force_split.nii.gz"),
        "--coordinates",
        "grid");
    command("CThead bone.stl", "render", "--volume", head, "--segment", "bone=>=1500");
    command("CThead bone.nii.gz", "info", "--volume", head, "--segment", "bone=>=1500");
    command("dicom.nrrd", "info", "--volume", data.resolve("LIDC/dicom_10slices"));
    command("j2k.nrrd", "info", "--volume", data.resolve("totalseg/dicom_j2k"));
    command("atlas.nii.gz", "info", "--volume", data.resolve("labels/HN-Atlas-labels.nrrd"));
  }

  private void replay(String name, Path trajectory, Object... more) throws IOException {
    Path frames = folder.resolve("frames.csv");
    Path legs = folder.resolve("legs.csv");
    Path report = folder.resolve("report.json");
    List<Object> arguments = new ArrayList<>(List.of("replay", "--trajectory", trajectory));
    arguments.addAll(List.of(more));
    arguments.addAll(List.of("--out", frames, "--legs", legs, "--report", report));
    CommandRun.of(arguments.toArray()).mustSucceed();
    checksums.put("replay " + name + " frames.csv", sha256(Files.readAllBytes(frames)));
    checksums.put("replay " + name + " legs.csv", sha256(Files.readAllBytes(legs)));
    checksums.put("replay " + name + " report.json", numbers(report));
  }

  private void writeSurfacesAndVolumes() throws IOException {
    for (String phantom : PHANTOMS) {
      command(phantom.replace(':', ' ') + ".stl", "render", "--phantom", phantom);
      command(phantom.replace(':', ' ') + ".nrrd", "info", "--phantom", phantom);
    }
    command("head.ply", "render", "--phantom", "head:96");
    command(
        "torus bits.ply",
        "render",
        "--phantom",
        "torus:64:grey",
        "--surface",
        "bits",
        "--segment",
        "b=>=500");
    command("head.nii", "info", "--phantom", "head:96:grey");
    command("torus.nii.gz", "info", "--phantom", "torus:64:grey", "--segment", "b=300..900");
  }

  /** Runs a command that writes one file, whose name says the format, and a report. */
  private void command(String fileName, String command, Object... more) throws IOException {
    Path out = folder.resolve(fileName.replace(' ', '-'));
    Path report = folder.resolve("report.json");
    List<Object> arguments = new ArrayList<>(List.of(command));
    arguments.addAll(List.of(more));
    arguments.addAll(List.of(command.equals("info") ? "--export" : "--out", out));
    arguments.addAll(List.of("--report", report));
    CommandRun.of(arguments.toArray()).mustSucceed();
    checksums.put(command + " " + fileName, sha256(Files.readAllBytes(out)));
    checksums.put(command + " " + fileName + " report.json", numbers(report));
    Files.delete(out);
  }

  private void drawPictures() throws IOException {
    Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), FRAMES, 96, 20130701);
    draw("head", "--phantom", "head:96");
    draw("head touched", "--phantom", "head:96", "--trajectory", trajectory);
    draw("slices", "--phantom", "head:96:grey", "--segment", "b=>=500", "--slices", "middle");
    draw("torus light", "--phantom", "torus:64", "--theme", "light", "--view", "front");
    draw("anaglyph", "--phantom", "torus:64", "--stereo", "anaglyph", "--zoom", "1.5");
  }

  /** The middle of a picture holds no caption. */
  private void draw(String name, Object... more) throws IOException {
    Path out = folder.resolve("picture.png");
    List<Object> arguments = new ArrayList<>(List.of("render", "--size", "640x480", "--out", out));
    arguments.addAll(List.of(more));
    CommandRun.of(arguments.toArray()).mustSucceed();
    BufferedImage image = ImageIO.read(out.toFile());
    ByteBuffer pixels = ByteBuffer.allocate(4 * 400 * 320);
    for (int y = 80; y < 400; y++) {
      for (int x = 120; x < 520; x++) {
        pixels.putInt(image.getRGB(x, y));
      }
    }
    checksums.put("picture " + name, sha256(pixels.array()));
  }

  private static String numbers(Path report) throws IOException {
    StringBuilder text = new StringBuilder();
    FlatJson.read(report)
        .forEach(
            (key, value) -> {
              if (!key.matches(NOT_COMPARED)) {
                text.append(key).append('=').append(value).append('\n');
              }
            });
    return sha256(text.toString().getBytes(StandardCharsets.UTF_8));
  }

  private static String sha256(byte[] bytes) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
    } catch (NoSuchAlgorithmException e) {
      throw new UncheckedIOException(new IOException(e));
    }
  }
}
