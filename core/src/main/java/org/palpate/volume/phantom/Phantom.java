package org.palpate.volume.phantom;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.SpecificationException;
import org.palpate.volume.VoxelGrid;

/**
 * A synthetic cube of voxels, the same to the bit each time and on every machine. Immutable; any
 * thread. Voxels are cubes of 1 mm, and grid coordinates equal world coordinates.
 *
 * <p>With labels, a voxel is solid if its centre is. With grey values, it has the fraction of
 * {@link #SOLID_GREY} that is solid, measured at 64 points. So the surface lies at half of it,
 * {@link #HALF_GREY}; {@link #thresholds} returns the values to segment at. The one-voxel walls of
 * a head are whole voxels in both. A maze has no surface between voxels: its grey values are full
 * in the walls and stay below half beside them.
 *
 * @param kind the content
 * @param edge the voxels along each edge, {@link #MIN_EDGE} to {@link #MAX_EDGE}
 * @param grey whether the voxels have grey values instead of labels
 * @param seed selects the maze; the other kinds do not depend on it
 */
public record Phantom(Kind kind, int edge, boolean grey, long seed) {
  /** The smallest edge, voxels. */
  public static final int MIN_EDGE = 16;

  /** The largest edge, voxels. */
  public static final int MAX_EDGE = 4096;

  /** The edge of a phantom whose spec names none, voxels. */
  public static final int DEFAULT_EDGE = 256;

  /** The seed of a phantom that {@link #parse} returns. */
  public static final long DEFAULT_SEED = 1;

  /** The grey value of a voxel that is solid throughout. */
  public static final int SOLID_GREY = 1000;

  /** The grey value of a voxel that is half solid: the threshold to segment at. */
  public static final int HALF_GREY = SOLID_GREY / 2;

  /** The content of a phantom. */
  public enum Kind {
    /** Skull with one-voxel walls, a separate jaw, skin around it. */
    HEAD,
    /** A solid ball. */
    SPHERE,
    /** A closed hollow ball with a wall of one voxel. */
    SHELL,
    /** The half-space below a tilted plane. */
    PLANE,
    /** A solid torus. */
    TORUS,
    /** Diagonal walls whose voxels share edges and corners but no face. */
    MAZE,
    /** A cuboid on a slab, two segments. */
    BLOCK
  }

  /**
   * A label of a phantom.
   *
   * @param value the number of the label, from 1
   * @param name the name of the segment
   * @param rgb the colour for drawing, 0xRRGGBB
   */
  public record Label(int value, String name, int rgb) {}

  /**
   * A segment that a threshold makes of the grey values.
   *
   * @param name the name of the segment
   * @param atLeast the smallest grey value of its voxels
   */
  public record Threshold(String name, int atLeast) {}

  /**
   * Checks the edge.
   *
   * @throws SpecificationException if the edge is out of range
   */
  public Phantom {
    if (edge < MIN_EDGE || edge > MAX_EDGE) {
      throw new SpecificationException(
          "phantom edge out of range", "edge=" + edge, "choose " + MIN_EDGE + " to " + MAX_EDGE);
    }
  }

  /**
   * {@return what {@code NAME[:EDGE][:grey]} specifies, as in {@code torus:192:grey}}
   *
   * @param spec the text of a user
   * @throws SpecificationException if the text is no phantom; the message names what to choose
   */
  public static Phantom parse(String spec) {
    String[] parts = spec.split(":", -1);
    boolean grey = parts.length > 1 && parts[parts.length - 1].equals("grey");
    int used = grey ? parts.length - 1 : parts.length;
    if (used > 2) {
      throw new SpecificationException("phantom not understood", spec, "write NAME[:EDGE][:grey]");
    }
    int edge = used == 2 ? parseEdge(parts[1], spec) : DEFAULT_EDGE;
    return new Phantom(parseKind(parts[0], spec), edge, grey, DEFAULT_SEED);
  }

  private static Kind parseKind(String name, String spec) {
    for (Kind kind : Kind.values()) {
      if (kind.name().toLowerCase(Locale.ROOT).equals(name)) {
        return kind;
      }
    }
    throw new SpecificationException(
        "no such phantom",
        spec,
        "choose head, sphere, shell, plane, torus, maze, block or fracture");
  }

  private static int parseEdge(String edge, String spec) {
    if (!edge.matches("[0-9]{1,9}")) {
      throw new SpecificationException(
          "phantom edge is not a number", spec, "write NAME[:EDGE][:grey]");
    }
    return Integer.parseInt(edge);
  }

  /** {@return the text from which {@link #parse} makes this phantom, but for the seed} */
  public String spec() {
    return kind.name().toLowerCase(Locale.ROOT) + ":" + edge + (grey ? ":grey" : "");
  }

  /** {@return the grid} */
  public VoxelGrid grid() {
    return VoxelGrid.ofUnitVoxels(edge, edge, edge);
  }

  /** {@return the labels in ascending order; the same with and without grey values} */
  public List<Label> labels() {
    if (kind == Kind.HEAD) {
      return List.of(
          new Label(HeadAnatomy.SKULL, "skull", 0xE8DCC0),
          new Label(HeadAnatomy.JAW, "jaw", 0xC9A97A),
          new Label(HeadAnatomy.SKIN, "skin", 0xE0A890));
    }
    if (kind == Kind.BLOCK) {
      return List.of(
          new Label(BlockAnatomy.BLOCK, "block", 0xE0A890),
          new Label(BlockAnatomy.BASE, "base", 0xE8DCC0));
    }
    return List.of(new Label(1, kind.name().toLowerCase(Locale.ROOT), 0xD8D0C0));
  }

  /** {@return the thresholds for grey values: half way between empty space and each matter} */
  public List<Threshold> thresholds() {
    if (kind == Kind.HEAD) {
      int betweenSkinAndBone = (HeadAnatomy.SKIN_GREY + SOLID_GREY) / 2;
      return List.of(
          new Threshold("bone", betweenSkinAndBone),
          new Threshold("head", HeadAnatomy.SKIN_GREY / 2));
    }
    return List.of(new Threshold(kind.name().toLowerCase(Locale.ROOT), HALF_GREY));
  }

  /**
   * {@return a segment for each label, with or without grey values} At an edge of 256 voxels this
   * takes a fraction of a second and 2 MB a label.
   */
  public SegmentedVolume segments() {
    List<Label> labels = labels();
    BitCube[] cubes = new BitCube[labels.size()];
    for (int n = 0; n < cubes.length; n++) {
      cubes[n] = new BitCube(edge, edge, edge);
    }
    new PhantomBrickWriter(bricks(false), edge).writeLabels(cubes);
    List<Segment> segments = new ArrayList<>();
    for (int n = 0; n < cubes.length; n++) {
      segments.add(new Segment(labels.get(n).name(), cubes[n], labels.get(n).rgb()));
    }
    return new SegmentedVolume(grid(), segments);
  }

  /** {@return a reader of the voxels, labels or grey values, slice by slice} */
  public PhantomSlices slices() {
    return new PhantomSlices(new PhantomBrickWriter(bricks(grey), edge), edge, grey);
  }

  /** {@return the analytic surface; empty for a head, a maze or a block} */
  public Optional<AnalyticSurface> analyticSurface() {
    return PhantomShapes.analyticSurface(kind, edge);
  }

  private BrickSource bricks(boolean asGrey) {
    return kind == Kind.MAZE
        ? new Maze(seed)
        : new AnatomyVoxelizer(PhantomShapes.anatomy(kind, edge, asGrey));
  }
}
