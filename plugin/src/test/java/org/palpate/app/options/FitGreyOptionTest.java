package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.force.guide.FitTarget;
import org.palpate.fracture.Residual;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

/** Two slabs of a scan with the surfaces 12.3 and 15.7 mm up, between voxels. */
class FitGreyOptionTest {
  private static final int EDGE = 28;
  private static final double LOWER_TOP = 12.3;
  private static final double UPPER_BOTTOM = 15.7;
  private static final int FULL = 2000;
  private static final int THRESHOLD = 1000;
  private static final ContactOptions CONTACT = Given.options(new ContactOptions());

  @TempDir private Path folder;

  private final StringWriter notes = new StringWriter();
  private final PrintWriter err = new PrintWriter(notes);

  private static FeelOptions options(String... arguments) {
    return Given.options(new FeelOptions(), arguments);
  }

  /** Returns the grey value of a voxel: the part of it that a slab fills. */
  private static int value(int i, int j, int k) {
    boolean isBeside = Math.min(i, j) < 4 || Math.max(i, j) >= 24 || k < 4 || k >= 24;
    double lower = Math.max(0, Math.min(1, LOWER_TOP - k));
    double upper = Math.max(0, Math.min(1, k + 1 - UPPER_BOTTOM));
    return isBeside ? 0 : (int) Math.round(FULL * Math.max(lower, upper));
  }

  private Path scan(String name, String origin) throws IOException {
    String header =
        "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 28 28 28\n"
            + "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: "
            + origin
            + "\nendian: little\nencoding: raw\n\n";
    ByteBuffer bytes =
        ByteBuffer.allocate(header.length() + 2 * EDGE * EDGE * EDGE)
            .order(ByteOrder.LITTLE_ENDIAN);
    bytes.put(header.getBytes(StandardCharsets.US_ASCII));
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      bytes.putShort((short) value(n % EDGE, n / EDGE % EDGE, n / EDGE / EDGE));
    }
    return Files.write(folder.resolve(name), bytes.array());
  }

  private static SegmentedVolume slabs(VoxelGrid grid) {
    List<Segment> slabs = new ArrayList<>();
    for (int slab = 0; slab < 2; slab++) {
      BitCube bits = new BitCube(EDGE, EDGE, EDGE);
      for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
        int k = n / EDGE / EDGE;
        if (value(n % EDGE, n / EDGE % EDGE, k) >= THRESHOLD && k < 14 == (slab == 0)) {
          bits.set(n % EDGE, n / EDGE % EDGE, k);
        }
      }
      slabs.add(new Segment("slab" + slab, bits, 0));
    }
    return new SegmentedVolume(grid, slabs);
  }

  /** Returns how far down the fit moves the upper slab, mm. */
  private double movesDown(String... arguments) throws IOException {
    SegmentedVolume slabs = slabs(VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE));
    FitTarget fit =
        options(arguments)
            .faceFit(slabs, CoordinateSystem.LPS, err)
            .orElseThrow()
            .fit(1, other -> false, List.of(new Pose(), new Pose()))
            .orElseThrow();
    BitCube upper = slabs.segments().get(1).bits();
    Vec3 before = Residual.centroid(new PosedBits(upper, slabs.grid(), new Pose()));
    return before.z - fit.pose().translation.z;
  }

  @Test
  void theFitFollowsTheGreyValuesOfTheScan() throws IOException {
    Path scan = scan("scan.nrrd", "(0.5,0.5,0.5)");
    double truth = UPPER_BOTTOM - LOWER_TOP;
    assertEquals(truth, movesDown("--guide=fit", "--fit-grey=" + scan + ":>=" + THRESHOLD), 0.1);
    assertEquals(4, movesDown("--guide=fit"), 0.05);
  }

  @Test
  void unknownAxesOfTheScanAreNoted() throws IOException {
    Path scan = scan("scan.nrrd", "(0.5,0.5,0.5)");
    FitGreyOption option = Given.options(new FitGreyOption(), "--fit-grey=" + scan + ":>=1000");
    SegmentedVolume slabs = slabs(VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE));
    option.partialVoxels(slabs, CoordinateSystem.LPS, err);
    assertEquals("", notes.toString());
    option.partialVoxels(slabs, CoordinateSystem.UNKNOWN, err);
    assertEquals(
        "The world axes of " + scan + " are taken as those of the scene.",
        notes.toString().strip());
  }

  @Test
  void aScanWithOtherVoxelsIsRefused() throws IOException {
    Path other = scan("other.nrrd", "(0.9,0.5,0.5)");
    Given.refuses(
        "no body has the voxels of the scan: --fit-grey "
            + other
            + ":>=1000: choose the scan from which the fragments were made, cropped and resampled"
            + " as it was",
        () -> movesDown("--guide=fit", "--fit-grey=" + other + ":>=1000"));
  }

  @Test
  void aBodyWithOtherVoxelsFollowsThem() throws IOException {
    Path scan = scan("scan.nrrd", "(0.5,0.5,0.5)");
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);
    VoxelGrid other =
        new VoxelGrid(
            EDGE,
            EDGE,
            EDGE,
            new Vec3(1, 1, 1),
            new RigidTransform(
                new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3(0, 0, 0.3)));
    SegmentedVolume slabs = new SegmentedVolume(grid, slabs(grid).segments(), List.of(grid, other));
    FitGreyOption option =
        Given.options(new FitGreyOption(), "--fit-grey=" + scan + ":>=" + THRESHOLD);
    assertTrue(option.partialVoxels(slabs, CoordinateSystem.LPS, err).get(0).isPresent());
    assertTrue(option.partialVoxels(slabs, CoordinateSystem.LPS, err).get(1).isEmpty());
  }

  @Test
  void theScanIsAnInput() throws IOException {
    Path scan = scan("a:>=b.nrrd", "(0.5,0.5,0.5)");
    assertEquals(List.of(scan), options("--fit-grey=" + scan + ":>=5").files());
  }

  @Test
  void theDataFileOfAScanIsAnInputToo() throws IOException {
    Path data = Files.write(folder.resolve("scan.raw"), new byte[8]);
    Path scan =
        Files.writeString(
            folder.resolve("scan.nhdr"),
            """
            NRRD0004
            type: uint8
            dimension: 3
            sizes: 2 2 2
            encoding: raw
            data file: scan.raw
            """);
    assertEquals(List.of(scan, data), options("--fit-grey=" + scan + ":>=5").files());
  }

  @ParameterizedTest
  @ValueSource(strings = {"scan.nrrd", ":>=5", "scan.nrrd:>=", "scan.nrrd:>=x", "s.nrrd:>=NaN"})
  void whatIsNoScanAndThresholdIsRefused(String text) {
    Given.refuses(
        "the grey values of a fit cannot be read: --fit-grey "
            + text
            + ": write a file and a threshold, as in 'chin.nrrd:>=1500'",
        () -> options("--guide=fit", "--fit-grey=" + text).check(false, CONTACT));
  }

  @Test
  void aFileThatIsNotThereIsNamed() {
    Path missing = folder.resolve("missing.nrrd");
    IOException e =
        assertThrows(
            IOException.class, () -> movesDown("--guide=fit", "--fit-grey=" + missing + ":>=5"));
    assertTrue(e.getMessage().contains(missing.toString()), e.getMessage());
  }

  @Test
  void greyValuesOfAFitNeedAFit() {
    Given.refuses(
        "grey values of a fit need a fit: --fit-grey s.nrrd:>=5: add --guide fit",
        () -> options("--fit-grey=s.nrrd:>=5").check(false, CONTACT));
  }
}
