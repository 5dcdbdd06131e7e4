package org.palpate.volume.phantom;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * A cube of voxels made by formula, the same to the bit each time and everywhere. Immutable; any
 * thread. Voxels are cubes of 1 mm and grid coordinates are world coordinates.
 *
 * <p>As labels, a voxel is solid where its centre is. As grey values it holds its share of {@link
 * #SOLID_GREY} that is solid, measured at 64 points, so that half of it, {@link #HALF_GREY}, is
 * where the surface lies; {@link #thresholds} tells which values to take. The one-voxel walls of a
 * head are whole voxels in both. A maze has no surface between voxels: its grey values are full at
 * the walls and stay under half beside them.
 *
 * @param kind what it shows
 * @param edge voxels along each edge, {@link #LEAST_EDGE} to {@link #LARGEST_EDGE}
 * @param grey whether its voxels hold grey values rather than labels
 * @param seed which of all mazes; other kinds do not depend on it
 */
public record Phantom(Kind kind, int edge, boolean grey, long seed) {
  public static final int LEAST_EDGE = 16;
  public static final int LARGEST_EDGE = 4096;
  public static final int DEFAULT_EDGE = 256;
  public static final long DEFAULT_SEED = 1;

  /** Grey value of a voxel that is solid all through. */
  public static final int SOLID_GREY = 1000;

  /** Grey value of a voxel that is half solid: the threshold to segment at. */
  public static final int HALF_GREY = SOLID_GREY / 2;

  /** What a phantom shows. */
  public enum Kind {
    /** Skull with one-voxel walls, a separate jaw, skin around it. */
    HEAD,
    /** A solid ball. */
    SPHERE,
    /** A closed hollow ball with a wall of one voxel. */
    SHELL,
    /** All that lies below a tilted plane. */
    PLANE,
    /** A solid ring. */
    TORUS,
    /** Diagonal walls that hold together by edges and corners alone. */
    MAZE
  }

  /**
   * A label that occurs.
   *
   * @param value from 1
   * @param name of the segment
   * @param rgb colour for drawing, 0xRRGGBB
   */
  public record Label(int value, String name, int rgb) {}

  /**
   * A segment that grey values can give.
   *
   * @param name of the segment
   * @param atLeast the least value of a voxel that belongs to it
   */
  public record Threshold(String name, int atLeast) {}

  /** Checks the edge. */
  public Phantom {
    if (edge < LEAST_EDGE || edge > LARGEST_EDGE) {
      throw new IllegalArgumentException(
          "phantom edge out of range: edge="
              + edge
              + ": choose "
              + LEAST_EDGE
              + " to "
              + LARGEST_EDGE);
    }
  }

  /**
   * Reads {@code NAME[:EDGE][:grey]}, as in {@code torus:192:grey}.
   *
   * @throws IllegalArgumentException with what is wrong, where, and what to choose instead
   */
  public static Phantom parse(String spec) {
    String[] parts = spec.split(":", -1);
    boolean grey = parts.length > 1 && parts[parts.length - 1].equals("grey");
    int used = grey ? parts.length - 1 : parts.length;
    if (used > 2) {
      throw new IllegalArgumentException(
          "phantom not understood: " + spec + ": write NAME[:EDGE][:grey]");
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
    throw new IllegalArgumentException(
        "no such phantom: " + spec + ": choose head, sphere, shell, plane, torus or maze");
  }

  private static int parseEdge(String edge, String spec) {
    if (!edge.matches("[0-9]{1,9}")) {
      throw new IllegalArgumentException(
          "phantom edge is not a number: " + spec + ": write NAME[:EDGE][:grey]");
    }
    return Integer.parseInt(edge);
  }

  /** Its name as {@link #parse} reads it. */
  public String spec() {
    return kind.name().toLowerCase(Locale.ROOT) + ":" + edge + (grey ? ":grey" : "");
  }

  public VoxelGrid grid() {
    return VoxelGrid.ofUnitVoxels(edge, edge, edge);
  }

  /** The labels that occur, in ascending order of value; alike with and without grey. */
  public List<Label> labels() {
    if (kind == Kind.HEAD) {
      return List.of(
          new Label(HeadAnatomy.SKULL, "skull", 0xE8DCC0),
          new Label(HeadAnatomy.JAW, "jaw", 0xC9A97A),
          new Label(HeadAnatomy.SKIN, "skin", 0xE0A890));
    }
    return List.of(new Label(1, kind.name().toLowerCase(Locale.ROOT), 0xD8D0C0));
  }

  /** What to segment grey values by: half way from empty to the matter in question. */
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
   * Makes a segment of each label, grey or not. At 256 voxels an edge it takes a fraction of a
   * second and 2 MB a label.
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

  /** A reader of its voxels, labels or grey values, slice by slice. */
  public PhantomSlices slices() {
    return new PhantomSlices(new PhantomBrickWriter(bricks(grey), edge), edge, grey);
  }

  /** The surface by formula; none for a head or a maze. */
  public Optional<AnalyticSurface> truth() {
    return PhantomShapes.truth(kind, edge);
  }

  private BrickSource bricks(boolean asGrey) {
    return kind == Kind.MAZE
        ? new Maze(seed)
        : new AnatomyVoxelizer(PhantomShapes.anatomy(kind, edge, asGrey));
  }
}
