package org.palpate.volume.phantom;

import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.volume.BitCube;
import org.palpate.volume.SpecificationException;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;
import org.palpate.volume.fracture.FragmentScatter;
import org.palpate.volume.fracture.Fragments;

/**
 * A broken bone like a lower jaw, with known truth: an arch of bone with marrow, cut into fragments
 * that are displaced and rotated. Immutable; any thread. Voxels are cubes of 1 mm, and grid
 * coordinates equal world coordinates.
 *
 * @param edge the voxels along each edge of the cube, {@link #MIN_EDGE} to {@link #MAX_EDGE}
 * @param fracture the number of fragments, the seed and the saw kerf
 */
public record FracturePhantom(int edge, FractureSpec fracture) {
  /** The name in a specification. */
  public static final String NAME = "fracture";

  /** The smallest edge, voxels. */
  public static final int MIN_EDGE = 64;

  /** The largest edge, voxels. */
  public static final int MAX_EDGE = 1024;

  /** The edge of a phantom whose spec names none, voxels. */
  public static final int DEFAULT_EDGE = 160;

  /** The number of fragments of a phantom whose spec names none. */
  public static final int DEFAULT_PARTS = 4;

  /**
   * Checks the edge.
   *
   * @throws SpecificationException if the edge is out of range
   */
  public FracturePhantom {
    if (edge < MIN_EDGE || edge > MAX_EDGE) {
      throw new SpecificationException(
          "phantom edge out of range", "edge=" + edge, "choose " + MIN_EDGE + " to " + MAX_EDGE);
    }
  }

  /**
   * {@return whether a specification names this phantom}
   *
   * @param spec the text of a user, not null
   */
  public static boolean accepts(String spec) {
    return spec.equals(NAME) || spec.startsWith(NAME + ":");
  }

  /**
   * {@return what {@code fracture[:EDGE[:PARTS[:SEED[:KERF]]]]} specifies}
   *
   * @param spec the text of a user, one that {@link #accepts} takes
   * @throws SpecificationException if the text has another form; the message says what to write
   */
  public static FracturePhantom parse(String spec) {
    String[] words = spec.split(":", 3);
    String edge = words.length > 1 ? words[1] : Integer.toString(DEFAULT_EDGE);
    if (!edge.matches("[0-9]{1,9}")) {
      throw new SpecificationException(
          "phantom edge is not a number", spec, "write fracture[:EDGE[:PARTS[:SEED[:KERF]]]]");
    }
    if (!spec.matches(NAME + "(:[0-9]{1,9}(:[0-9]{1,9}(:[0-9]{1,18}(:[0-9]{1,9})?)?)?)?")) {
      throw new SpecificationException(
          "phantom fracture not understood",
          spec,
          "write fracture[:EDGE[:PARTS[:SEED[:KERF]]]], for example fracture:160:4:7:1");
    }
    String fracture = words.length > 2 ? words[2] : Integer.toString(DEFAULT_PARTS);
    return new FracturePhantom(Integer.parseInt(edge), FractureSpec.parse(fracture));
  }

  /** {@return the text from which {@link #parse} makes this phantom} */
  public String spec() {
    return NAME + ":" + edge + ":" + fracture;
  }

  /** {@return the grid} */
  public VoxelGrid grid() {
    return VoxelGrid.ofUnitVoxels(edge, edge, edge);
  }

  /** {@return the bone before it broke} */
  public BitCube bone() {
    return JawArch.bone(edge);
  }

  /** {@return the fragments where they belong} */
  public Fragments fragments() {
    return FragmentCutter.cut(bone(), grid(), fracture);
  }

  /**
   * {@return the pose of each fragment after the fracture, from its place in the bone, world mm}
   * The first, the largest, is not displaced.
   *
   * @param fragments those that {@link #fragments} returned
   */
  public List<Pose> startPoses(Fragments fragments) {
    return FragmentScatter.scatter(fragments, fracture.seed(), true);
  }
}
