package org.palpate.app.output;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.palpate.fracture.FractureReadings;
import org.palpate.fracture.PairReadings;
import org.palpate.fracture.fit.GhostDistance;
import org.palpate.host.placing.GhostReading;
import org.palpate.host.placing.ReadingText;
import org.palpate.io.file.CountText;
import org.palpate.io.file.NumberText;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.fracture.PosedBits;

/** The readings of the fragments of a scene, as lines and as a field of a report. */
public final class FractureReport {
  private final List<String> names;
  private final FractureReadings readings;
  private final List<ToGhost> toGhosts = new ArrayList<>();

  /** A reading of a body. */
  private record ToGhost(String body, GhostReading reading) {}

  /**
   * Reads the bodies of a scene where they stand, and those that can move against ghosts too; all
   * if none can move.
   *
   * @param ghosts the ghosts, if there are any
   */
  public FractureReport(PlacedVolume bodies, Optional<SegmentedVolume> ghosts) {
    this(bodies);
    ghosts.ifPresent(faint -> readGhosts(bodies, faint));
  }

  /** Reads the bodies of a scene where they stand. */
  public FractureReport(PlacedVolume bodies) {
    names = bodies.rest().segments().stream().map(Segment::name).toList();
    readings = FractureReadings.read(PosedBits.of(bodies.rest(), bodies.poses()));
  }

  private void readGhosts(PlacedVolume bodies, SegmentedVolume faint) {
    List<PosedBits> posed = PosedBits.of(bodies.rest(), bodies.poses());
    boolean readsAll = !bodies.hasMovableBodies();
    for (int n = 0; n < posed.size(); n++) {
      if (readsAll || bodies.isMovable(n)) {
        String name = names.get(n);
        GhostReading.of(posed.get(n), faint)
            .forEach(reading -> toGhosts.add(new ToGhost(name, reading)));
      }
    }
  }

  /**
   * Returns a line for each pair that faces each other, one for each that overlaps, one for each
   * body and ghost, and one for the whole.
   */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    for (FractureReadings.Pair pair : readings.pairs()) {
      lines.add(
          names.get(pair.one())
              + " to "
              + names.get(pair.other())
              + ": "
              + ReadingText.of(pair.readings()));
    }
    for (FractureReadings.Overlap each : readings.overlaps()) {
      lines.add(
          names.get(each.one())
              + " and "
              + names.get(each.other())
              + " overlap in "
              + CountText.of(each.voxels(), "pair")
              + " of voxels");
    }
    for (ToGhost each : toGhosts) {
      lines.add(each.reading().line(each.body()));
    }
    lines.add(
        "farthest from rest, relative to the largest: "
            + NumberText.thousandths(readings.residualMm())
            + " mm, "
            + NumberText.thousandths(readings.residualDegrees())
            + " degrees; "
            + CountText.of(readings.overlapVoxels(), "overlapping pair")
            + " of voxels");
    return lines;
  }

  /** Whether any two fragments overlap. */
  public boolean overlaps() {
    return !readings.overlaps().isEmpty();
  }

  /** Returns the field {@code fracture} of a report. */
  public Map<String, Object> field() {
    Map<String, Object> field = new LinkedHashMap<>();
    field.put("residual_mm", readings.residualMm());
    field.put("residual_deg", readings.residualDegrees());
    field.put("overlap_voxels", readings.overlapVoxels());
    List<Object> pairs = new ArrayList<>();
    for (FractureReadings.Pair pair : readings.pairs()) {
      PairReadings r = pair.readings();
      Map<String, Object> entry = new LinkedHashMap<>();
      entry.put("bodies", List.of(names.get(pair.one()), names.get(pair.other())));
      entry.put("gap_mean_mm", r.gapMeanMm());
      entry.put("gap_largest_mm", r.gapLargestMm());
      entry.put("step_off_mm", r.stepOffMm());
      entry.put("contact_mm2", r.contactMm2());
      entry.put("facing_mm2", r.facingMm2());
      entry.put("overlap_voxels", r.overlapVoxels());
      pairs.add(entry);
    }
    field.put("pairs", pairs);
    if (!toGhosts.isEmpty()) {
      field.put("ghosts", toGhosts.stream().map(FractureReport::entry).toList());
    }
    return field;
  }

  private static Map<String, Object> entry(ToGhost each) {
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("body", each.body());
    entry.put("ghost", each.reading().ghost());
    GhostDistance distance = each.reading().distance();
    entry.put("distance_mean_mm", distance.meanMm());
    entry.put("distance_p95_mm", distance.mostlyMm());
    entry.put("distance_largest_mm", distance.largestMm());
    entry.put("share", distance.share());
    return entry;
  }
}
