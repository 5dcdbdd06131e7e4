package org.palpate.io.scene;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.BitCube;

/**
 * Elastic matter of a scene file that no tool can touch, between bodies. In the file it is an
 * elastic body whose segment begins with {@code fill:}.
 *
 * @param name the name, unique among bodies and fills
 * @param source the volume that holds its voxels and those of a body
 * @param segment the text that chooses its voxels, as in {@code --segment} without the name
 * @param youngPa the elastic modulus, Pa
 * @param poisson the Poisson ratio
 */
public record SceneFill(
    String name, String source, String segment, double youngPa, OptionalDouble poisson) {
  /** The beginning of the segment of a fill in the file. */
  static final String PREFIX = "fill:";

  /** Returns a fill that is a label of a volume. */
  public static SceneFill ofLabel(
      String name, String volume, int label, double youngPa, double poisson) {
    return new SceneFill(name, volume, "label:" + label, youngPa, OptionalDouble.of(poisson));
  }

  /** Returns this fill with another name of the same file. */
  SceneFill at(String newSource) {
    return new SceneFill(name, newSource, segment, youngPa, poisson);
  }

  /**
   * Reads the voxels.
   *
   * @param sceneFile the scene file, to which the name of the volume is relative
   * @throws VolumeFormatException if the volume or the segment cannot be read, or has no voxel
   */
  public BitCube voxels(Path sceneFile) throws VolumeFormatException {
    Path file = sceneFile.toAbsolutePath().resolveSibling(source).normalize();
    List<SegmentSpec> wanted = List.of(SegmentSpec.parse("fill=" + segment));
    BitCube bits =
        SegmentBuilder.read(VolumeFiles.open(file, ReadOptions.defaults()), wanted)
            .segments()
            .get(0)
            .bits();
    if (bits.solidCount() == 0) {
      throw new VolumeFormatException(
          "the fill " + name + " has no voxel",
          sceneFile,
          "palpate info --volume prints the values of a volume");
    }
    return bits;
  }
}
