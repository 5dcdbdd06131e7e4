package org.palpate.app.options;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import org.palpate.app.process.PalpateException;
import org.palpate.io.resample.Plane;
import org.palpate.volume.ConnectedComponents.Neighbours;
import org.palpate.volume.Segment;
import org.palpate.volume.SpecificationException;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.fracture.SegmentSplit;
import picocli.CommandLine.Option;

/** The options that make fragments of the only segment of a volume. */
public final class FragmentOptions {
  private static final String COMPONENTS = "components";
  private static final String PLANE = "plane:";
  private static final long DEFAULT_LEAST_VOXELS = 64;

  @Option(
      names = "--fracture",
      paramLabel = "PARTS[:SEED[:KERF]]",
      description = {
        "Cuts the only segment into 2 to 8 fragments and exports these as labels. The cuts are"
            + " rough and depend on SEED. A saw takes KERF voxels away between them, 0 to 4."
            + " Default: seed 1, kerf 1."
      })
  private String fracture;

  @Option(
      names = "--split",
      paramLabel = "HOW",
      description = {
        "Splits the only segment and exports the parts as labels: components[:LEAST[:6|26]]"
            + " (connected components of at least LEAST voxels that share faces, or faces, edges"
            + " and corners; default 64 and 26), or plane:X,Y,Z,NX,NY,NZ (a point and a normal,"
            + " world mm)."
      })
  private String split;

  /** Whether fragments are wanted. */
  public boolean isWanted() {
    return fracture != null || split != null;
  }

  /** Whether the fragments are those of a synthetic fracture, which may be displaced. */
  public boolean isFracture() {
    return fracture != null;
  }

  /**
   * Checks what the options say, before their combination with others.
   *
   * @throws PalpateException exit code 2, if an option is not understood
   */
  public void checkText() {
    if (isFracture()) {
      spec();
    }
    if (split != null) {
      checkSplit();
    }
  }

  /**
   * Checks the combination of options.
   *
   * @param export the file of the fragments, or null
   * @throws PalpateException exit code 2, if an option contradicts or needs another
   */
  public void check(Path export) {
    if (!isWanted()) {
      return;
    }
    String given = isFracture() ? "--fracture " + fracture : "--split " + split;
    if (isFracture() && split != null) {
      throw PalpateException.wrongUse(
          "a segment is either broken or split", given + " with --split", "leave one of them out");
    }
    if (export == null) {
      throw PalpateException.wrongUse("the fragments have no file", given, "add --export FILE");
    }
  }

  /** Returns the specification of the fracture. */
  public FractureSpec spec() {
    try {
      return FractureSpec.parse(fracture);
    } catch (SpecificationException e) {
      throw PalpateException.wrongUse(e.what(), "--fracture " + fracture, e.remedy(), e);
    }
  }

  private void checkSplit() {
    if (plane().isEmpty() && !split.matches(COMPONENTS + "(:[0-9]{1,12}(:(6|26))?)?")) {
      throw PalpateException.wrongUse(
          "the split is not understood",
          "--split " + split,
          "write components, components:500, components:500:6 or plane:X,Y,Z,NX,NY,NZ");
    }
  }

  private Optional<Plane> plane() {
    return split.startsWith(PLANE)
        ? Plane.parse(split.substring(PLANE.length()))
        : Optional.empty();
  }

  /**
   * Returns the fragments.
   *
   * @param source the volume as the user knows it
   * @throws PalpateException exit code 2, if there is not exactly one segment, or it cannot be cut
   */
  public Fragments make(List<Segment> segments, VoxelGrid grid, String source) {
    if (segments.size() != 1) {
      throw PalpateException.wrongUse(
          String.format(
              Locale.ROOT,
              "a %s needs one segment, and there are %d",
              isFracture() ? "fracture" : "split",
              segments.size()),
          source,
          "choose one with --segment NAME=SPEC");
    }
    return checked(() -> make(segments.get(0), grid));
  }

  private Fragments make(Segment segment, VoxelGrid grid) {
    if (isFracture()) {
      return FragmentCutter.cut(segment.bits(), grid, spec());
    }
    Optional<Plane> plane = plane();
    if (plane.isPresent()) {
      return SegmentSplit.byPlane(
          segment.bits(), grid, plane.get().pointMm(), plane.get().normal());
    }
    String[] words = split.split(":", -1);
    boolean sharesFaces = words.length > 2 && words[2].equals("6");
    return SegmentSplit.byComponents(
        segment.bits(),
        grid,
        sharesFaces ? Neighbours.FACES : Neighbours.FACES_EDGES_CORNERS,
        words.length > 1 ? Long.parseLong(words[1]) : DEFAULT_LEAST_VOXELS);
  }

  private static <T> T checked(Supplier<T> supplier) {
    try {
      return supplier.get();
    } catch (IllegalArgumentException e) {
      throw PalpateException.wrongUse(e.getMessage(), e);
    }
  }
}
