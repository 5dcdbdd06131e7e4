package org.palpate.platform;

import static org.junit.jupiter.api.Assertions.assertEquals;

import ij.ImagePlus;
import ij.ImageStack;
import ij.io.FileSaver;
import ij.process.ShortProcessor;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.app.PalpateCommandLine;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeReader;

/** In the real ImageJ, every segment of real scans has the voxels that the command line counts. */
class RealImagejScansTest {
  private static final Path DATA = Path.of(System.getProperty("palpate.data", "../shared/data"));
  private static final Path CT_HEAD = DATA.resolve("CThead/CThead_u16gz.nrrd");
  private static final Path ATLAS = DATA.resolve("labels/HN-Atlas-labels.nrrd");
  private static final Path DICOM = DATA.resolve("LIDC/dicom_10slices");
  private static final Pattern VOXELS =
      Pattern.compile("\"name\" ?: ?\"([^\"]*)\"[^}]*?\"voxels\" ?: ?(\\d+)");

  private static final int DESK_HEIGHT = 768;

  @TempDir Path folder;

  @Test
  void segmentsEqualThoseOfTheCommandLineToTheVoxel() throws Exception {
    Assumptions.assumeTrue(
        Files.exists(CT_HEAD) && Files.exists(ATLAS) && Files.isDirectory(DICOM),
        "skipped: the scans are not in " + DATA.toAbsolutePath());
    writeTiff(CT_HEAD, folder.resolve("head.tif"), false);
    writeTiff(ATLAS, folder.resolve("atlas.tif"), false);
    String atlas = folder.resolve("atlas.tif").toString();
    Files.write(
        folder.resolve("counts.txt"),
        List.of(
            "head\thead.tif\tsegment=bone lower=1500 upper=65535",
            "atlas\tatlas.tif\tlabels",
            "dicom\t" + DICOM.toAbsolutePath() + "/\tsegment=bone lower=200 upper=4000"));
    try (XServer display = XServer.start()) {
      RealImagej.Seen seen = RealImagej.plain(folder).play(display, "counts");
      RealImagejTest.checkEnd(seen);
      assertEquals("bone\t336108", seen.of("counts head").strip());
      assertEquals(
          counts("--volume", CT_HEAD, "--segment", "bone=>=1500"), table(seen.of("counts head")));
      Map<String, Long> labels = table(seen.of("counts atlas"));
      assertEquals(60, labels.size());
      assertEquals(972_670, labels.values().stream().mapToLong(Long::longValue).sum());
      assertEquals(counts("--volume", atlas), labels);
      assertEquals(
          counts("--volume", DICOM, "--segment", "bone=200..4000"), table(seen.of("counts dicom")));
    }
  }

  /** Takes the picture of README if -Dpalpate.picture=FILE.png requests it. */
  @Test
  void takesThePictureOfReadme() throws Exception {
    String target = System.getProperty("palpate.picture", "");
    Assumptions.assumeTrue(
        !target.isEmpty(), "skipped: no -Dpalpate.picture=FILE.png was asked for");
    Assumptions.assumeTrue(Files.exists(CT_HEAD), "skipped: no CThead");
    writeTiff(CT_HEAD, folder.resolve("CThead.tif"), true);
    Files.write(folder.resolve("picture.csv"), BrowSlide.rows(folder.resolve("CThead.tif")));
    try (XServer display = XServer.start()) {
      RealImagej.Seen seen =
          RealImagej.plain(folder)
              .with("probe.picture", "CThead.tif")
              .with("probe.options", "segment=bone lower=1500 upper=65535 solver=smooth ")
              .with("probe.pause", 13_000)
              .with("probe.slice", BrowSlide.LAST_SLICE)
              .play(display, "picture");
      RealImagejTest.checkEnd(seen);
    }
    BufferedImage screen = ImageIO.read(folder.resolve("screen.png").toFile());
    BufferedImage desk = screen.getSubimage(0, 0, screen.getWidth(), DESK_HEIGHT);
    ImageIO.write(desk, "png", Path.of(target).toFile());
  }

  private static Map<String, Long> table(String lines) {
    Map<String, Long> table = new TreeMap<>();
    lines
        .lines()
        .map(line -> line.split("\t", -1))
        .forEach(row -> table.put(row[0].replaceFirst("^label ", ""), Long.parseLong(row[1])));
    return table;
  }

  /** Returns the counts of {@code palpate info}; labels by their number. */
  private Map<String, Long> counts(Object... arguments) throws IOException {
    Path report = folder.resolve("report.json");
    List<String> all = new ArrayList<>(List.of("info"));
    List.of(arguments).forEach(argument -> all.add(argument.toString()));
    all.addAll(List.of("--report", report.toString()));
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    int exitCode =
        new PalpateCommandLine(
                new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8))
            .run(all.toArray(String[]::new));
    assertEquals(0, exitCode, () -> err.toString(StandardCharsets.UTF_8));
    Map<String, Long> counts = new TreeMap<>();
    Matcher found = VOXELS.matcher(Files.readString(report));
    while (found.find()) {
      counts.put(found.group(1).replaceFirst("^\\D*(\\d+)$", "$1"), Long.parseLong(found.group(2)));
    }
    return counts;
  }

  /**
   * Writes a volume as a stack that ImageJ opens by itself, 16 bits per voxel.
   *
   * @param fromHead whether to reverse the order of the slices
   */
  private static void writeTiff(Path volume, Path target, boolean fromHead) throws IOException {
    VolumeReader reader = VolumeFiles.open(volume, ReadOptions.defaults());
    int width = reader.header().grid().sizeX();
    int height = reader.header().grid().sizeY();
    ImageStack slices = new ImageStack(width, height);
    reader.read(
        (k, slice) -> {
          ShortProcessor pixels = new ShortProcessor(width, height);
          for (int n = 0; n < slice.count(); n++) {
            pixels.set(n, (int) slice.value(n));
          }
          slices.addSlice("", pixels, fromHead ? 0 : slices.size());
        });
    ImagePlus image = new ImagePlus("scan", slices);
    image.getCalibration().setUnit("mm");
    image.getCalibration().pixelWidth = reader.header().grid().spacingMm().x;
    image.getCalibration().pixelHeight = reader.header().grid().spacingMm().y;
    image.getCalibration().pixelDepth = reader.header().grid().spacingMm().z;
    image.setDisplayRange(0, 2500);
    new FileSaver(image).saveAsTiffStack(target.toString());
  }
}
