package org.palpate.app.options;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.palpate.app.process.PalpateException;
import org.palpate.edit.BrushLimits;
import org.palpate.host.ContactScene;
import org.palpate.io.file.NumberParser;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import picocli.CommandLine.Option;

/** The options that choose a brush, which adds and erases voxels while a volume is touched. */
public final class BrushOptions {
  private static final double MOST_RADIUS_MM = 1000;
  private static final String FORM = "--brush ";

  @Option(
      names = "--brush",
      paramLabel = "MM|tool[,...]",
      description = {
        "A brush for correcting a segment by keys of the window: a ball with this radius in mm, or"
            + " the shape of the tool. After a comma follow segment:NAME (default: the first),"
            + " range:LOW..HIGH (only voxels with such a value change) and refuse (voxels that"
            + " would meet the tool stay empty; otherwise the tool is set free)."
      })
  private String brush;

  @Option(
      names = "--paint",
      paramLabel = "add|erase",
      description = "Adds or erases with --brush from the start on, until a key ends it.")
  private Paint paint;

  /** The stroke with which a session begins. */
  public enum Paint {
    /** Makes voxels solid. */
    ADD,
    /** Makes voxels empty. */
    ERASE
  }

  /**
   * A brush.
   *
   * @param radiusMm the radius of a ball, mm; if empty, the brush has the shape of the tool
   * @param segment index of the segment that it changes
   * @param limits what it must leave
   * @param start what it does from the start on, if anything
   */
  public record Brush(
      OptionalDouble radiusMm, int segment, BrushLimits limits, Optional<Paint> start) {}

  /** Whether a brush was asked for. */
  public boolean isGiven() {
    return brush != null;
  }

  /**
   * Checks what needs no volume.
   *
   * @param isRigid whether the tool has a shape
   * @param isPlaced whether the segments are bodies at poses
   * @throws PalpateException exit code 2, if an option is wrong
   */
  public void check(boolean isRigid, boolean isPlaced) {
    if (brush == null) {
      if (paint != null) {
        throw PalpateException.wrongUse(
            "painting needs a brush", "--paint", "add for example --brush 3");
      }
      return;
    }
    radiusMm();
    range();
    if (radiusMm().isEmpty() && !isRigid) {
      throw PalpateException.wrongUse(
          "a point has no shape", FORM + brush, "give a radius in mm, or choose a --tool");
    }
    if (isPlaced) {
      throw PalpateException.wrongUse(
          "a brush is for the segments of one volume", "--brush", "leave out --scene");
    }
  }

  /**
   * Returns the brush for a scene, if one was asked for.
   *
   * @param tool the rigid tool; empty for a point
   * @throws VolumeFormatException if the values that limit it cannot be read
   * @throws PalpateException exit code 2, if an option is wrong
   */
  public Optional<Brush> brush(VolumeSource source, ContactScene scene, Optional<RigidTool> tool)
      throws VolumeFormatException {
    if (brush == null) {
      return Optional.empty();
    }
    if (radiusMm().isEmpty() && tool.filter(RigidTool::isCovered).map(RigidTool::solid).isEmpty()) {
      throw PalpateException.wrongUse(
          "an open or thinned tool has no shape", FORM + brush, "give a radius in mm");
    }
    BrushLimits limits =
        new BrushLimits(
            voxels(source, range()), scene.protectedVoxels(), parts().contains("refuse"));
    return Optional.of(
        new Brush(
            radiusMm(), segment(scene.volume().segments()), limits, Optional.ofNullable(paint)));
  }

  private List<String> parts() {
    return List.of(brush.split(",", -1));
  }

  private OptionalDouble radiusMm() {
    String first = parts().get(0);
    if (first.equals("tool")) {
      return OptionalDouble.empty();
    }
    double mm = NumberParser.number(first);
    if (!(mm > 0 && mm <= MOST_RADIUS_MM)) {
      throw unreadable(
          "begin with a radius above 0 and up to 1,000 mm, or with tool, as in --brush 3,refuse");
    }
    return OptionalDouble.of(mm);
  }

  private int segment(List<Segment> segments) {
    Optional<String> name = part("segment:");
    return IntStream.range(0, segments.size())
        .filter(n -> name.isEmpty() || segments.get(n).name().equals(name.get()))
        .findFirst()
        .orElseThrow(() -> unreadable("there is no such segment; list them with palpate info"));
  }

  private Optional<SegmentSpec> range() {
    for (String part : parts().subList(1, parts().size())) {
      boolean isKnown =
          part.equals("refuse") || part.startsWith("segment:") || part.startsWith("range:");
      if (!isKnown) {
        throw unreadable("write segment:NAME, range:LOW..HIGH or refuse after the commas");
      }
    }
    Optional<String> text = part("range:");
    if (text.isEmpty()) {
      return Optional.empty();
    }
    try {
      return Optional.of(SegmentSpec.parse("range=" + text.get()));
    } catch (VolumeFormatException e) {
      throw unreadable("write a range as LOW..HIGH or >=LOW");
    }
  }

  private Optional<String> part(String key) {
    return parts().stream()
        .filter(part -> part.startsWith(key))
        .map(part -> part.substring(key.length()))
        .findFirst();
  }

  private static Optional<BitCube> voxels(VolumeSource source, Optional<SegmentSpec> range)
      throws VolumeFormatException {
    return range.isPresent()
        ? Optional.of(source.read(List.of(range.get())).segments().get(0).bits())
        : Optional.empty();
  }

  private PalpateException unreadable(String remedy) {
    return PalpateException.wrongUse("the brush cannot be read", FORM + brush, remedy);
  }
}
