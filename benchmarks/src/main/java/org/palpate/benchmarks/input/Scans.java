package org.palpate.benchmarks.input;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentedVolume;

/**
 * The bone of a scan that stands for the data of the paper's Table 1, in its own size or resampled
 * (nearest voxel) to the paper's size.
 *
 * @param bone the voxels
 * @param spacingMm the edge lengths of a voxel
 */
public record Scans(BitCube bone, Vec3 spacingMm) {
  /** The names of all scans, for {@link #read}. */
  public static final List<String> NAMES =
      List.of(
          "CThead 256x256x113", "CThead to 532x532x464", "LIDC 512x512x275", "LIDC to 512x512x520");

  private static final String TO = " to ";

  /**
   * Reads a scan and resamples it if its name says so.
   *
   * @param folder the folder of the data
   */
  public static Scans read(Path folder, String name) throws IOException {
    boolean head = name.startsWith("CThead");
    Path file =
        folder.resolve(
            head ? "CThead/CThead_u16gz.nrrd" : "LIDC/LIDC-IDRI-0314_ge100HU_i16gz.nrrd");
    SegmentedVolume volume =
        SegmentBuilder.read(
            VolumeFiles.open(file, ReadOptions.defaults()),
            List.of(SegmentSpec.atLeast("bone", head ? 1500 : 200)));
    Scans scan = new Scans(volume.segments().get(0).bits(), volume.grid().spacingMm());
    int at = name.indexOf(TO);
    return at < 0 ? scan : scan.resampled(name.substring(at + TO.length()).split("x", -1));
  }

  private Scans resampled(String... sizes) {
    BitCube to =
        new BitCube(
            Integer.parseInt(sizes[0]), Integer.parseInt(sizes[1]), Integer.parseInt(sizes[2]));
    for (int k = 0; k < to.sizeZ(); k++) {
      int z = (int) ((k + 0.5) * bone.sizeZ() / to.sizeZ());
      for (int j = 0; j < to.sizeY(); j++) {
        int y = (int) ((j + 0.5) * bone.sizeY() / to.sizeY());
        for (int i = 0; i < to.sizeX(); i++) {
          if (bone.get((int) ((i + 0.5) * bone.sizeX() / to.sizeX()), y, z)) {
            to.set(i, j, k);
          }
        }
      }
    }
    Vec3 spacing =
        new Vec3(
            spacingMm.x * bone.sizeX() / to.sizeX(),
            spacingMm.y * bone.sizeY() / to.sizeY(),
            spacingMm.z * bone.sizeZ() / to.sizeZ());
    return new Scans(to, spacing);
  }
}
