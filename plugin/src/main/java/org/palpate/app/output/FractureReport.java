package org.palpate.app.output;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.palpate.fracture.FractureReadings;
import org.palpate.fracture.PairReadings;
import org.palpate.host.placing.ReadingText;
import org.palpate.io.file.CountText;
import org.palpate.io.file.NumberText;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.volume.Segment;
import org.palpate.volume.fracture.PosedBits;

/** The readings of the fragments of a scene, as lines and as a field of a report. */
public final class FractureReport {
  private final List<String> names;
  private final FractureReadings readings;

  /** Reads the bodies of a scene where they stand. */
  public FractureReport(PlacedVolume bodies) {
    names = bodies.rest().segments().stream().map(Segment::name).toList();
    readings = FractureReadings.read(PosedBits.of(bodies.rest(), bodies.poses()));
  }

  /**
   * Returns a line for each pair that faces each other, one for each that overlaps, and one for the
   * whole.
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
    return field;
  }
}
