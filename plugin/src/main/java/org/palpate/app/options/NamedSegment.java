package org.palpate.app.options;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.palpate.app.process.PalpateException;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/** Finds the segments that options name. */
final class NamedSegment {
  /** The most segments whose names a line lists. */
  private static final int MOST_LISTED = 8;

  private NamedSegment() {}

  /**
   * Returns the segment of a name.
   *
   * @param option the option that names it, with a blank
   * @param text the value of the option
   * @throws PalpateException exit code 2, if there is no such segment
   */
  static Segment of(SegmentedVolume segments, String option, String text, String name) {
    return find(segments, name)
        .orElseThrow(
            () ->
                PalpateException.wrongUse(
                    "there is no such segment", option + text, remedy(segments.segments())));
  }

  /** Returns the segment of a name; empty if there is none. */
  static Optional<Segment> find(SegmentedVolume segments, String name) {
    return segments.segments().stream().filter(each -> each.name().equals(name)).findFirst();
  }

  /** Returns the remedy for a name that is wrong: which or how many segments exist, if any do. */
  static String remedy(List<Segment> segments) {
    if (segments.isEmpty()) {
      return "the volume has no segment; choose one with --segment";
    }
    return segments.size() > MOST_LISTED
        ? "choose one of the " + segments.size() + " segments that palpate info lists"
        : "choose " + segments.stream().map(Segment::name).collect(Collectors.joining(" or "));
  }
}
