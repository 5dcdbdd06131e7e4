package org.palpate.app.options;

import java.util.List;
import org.palpate.app.process.PalpateException;
import org.palpate.volume.BitCube;
import org.palpate.volume.EnclosedSpace;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * An elastic segment that fills the space between two others and cannot be touched.
 *
 * @param name its name
 * @param outer the segment that encloses the space
 * @param inner the segment whose inside does not belong to it
 */
record ElasticFill(String name, String outer, String inner) {
  static final String OPTION = "--fill";

  /** The soft tissue of the phantom of a head, which is hollow below its skin. */
  static final ElasticFill OF_HEAD = new ElasticFill("tissue", "skin", "skull");

  /**
   * Reads {@code NAME=OUTER..INNER}.
   *
   * @throws PalpateException exit code 2, if the text is something else
   */
  static ElasticFill parse(String name, String between) {
    int dots = between.indexOf("..");
    if (name.isBlank() || dots <= 0 || dots + 2 == between.length()) {
      throw PalpateException.wrongUse(
          "a fill lies between two segments",
          OPTION + " " + name + "=" + between,
          "write NAME=OUTER..INNER, as in tissue=skin..skull");
    }
    return new ElasticFill(name, between.substring(0, dots), between.substring(dots + 2));
  }

  /** Whether a volume has the two segments. */
  boolean fits(SegmentedVolume volume) {
    return NamedSegment.find(volume, outer).isPresent()
        && NamedSegment.find(volume, inner).isPresent();
  }

  /**
   * Returns the voxels of the space.
   *
   * @throws PalpateException exit code 2, if a segment is missing or there is no space
   */
  BitCube voxels(SegmentedVolume volume) {
    if (NamedSegment.find(volume, name).isPresent()) {
      throw refusal("a segment has the name of the fill", "choose another name");
    }
    List<BitCube> solids = volume.segments().stream().map(Segment::bits).toList();
    BitCube space = EnclosedSpace.between(bits(volume, outer), bits(volume, inner), solids);
    if (space.solidCount() == 0) {
      throw refusal("there is no empty space between the segments", "leave it out");
    }
    return space;
  }

  private BitCube bits(SegmentedVolume volume, String segment) {
    return NamedSegment.find(volume, segment)
        .orElseThrow(
            () -> refusal("there is no segment " + segment, NamedSegment.remedy(volume.segments())))
        .bits();
  }

  private PalpateException refusal(String what, String remedy) {
    return PalpateException.wrongUse(
        what, OPTION + " " + name + "=" + outer + ".." + inner, remedy);
  }
}
