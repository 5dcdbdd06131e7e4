package org.palpate.elastic;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * The elastic segments of a volume, those that stand still beside them, and the edge of a cell. It
 * makes bodies at rest, one for each session or replay.
 *
 * @param metric the spacing of the grid
 * @param soft the segments that deform
 * @param still the voxels of the others
 * @param edgeMm the edge of a cell, mm; rounded to whole voxels
 * @param contactRadiusMm the radius of a contact, mm; if empty, two edges
 */
public record ElasticPlan(
    GridMetric metric,
    List<ElasticSegment> soft,
    List<BitCube> still,
    double edgeMm,
    OptionalDouble contactRadiusMm)
    implements Supplier<ElasticBody> {
  /** The number of cells over the elastic segments if the user chooses no edge. */
  private static final double USUAL_CELLS = 3000;

  /** Copies the lists. */
  public ElasticPlan {
    soft = List.copyOf(soft);
    still = List.copyOf(still);
  }

  /**
   * {@return the plan of a volume}
   *
   * @param volume the segments, on one grid
   * @param materials those of the elastic segments by name; all other segments stand still
   * @param fills what deforms too and is no segment of the volume
   * @param edgeMm the edge of a cell; if empty, some 3,000 cells cover the elastic segments
   */
  public static ElasticPlan of(
      SegmentedVolume volume,
      Map<String, ElasticMaterial> materials,
      List<ElasticSegment> fills,
      OptionalDouble edgeMm) {
    GridMetric metric = volume.grid().metric();
    List<ElasticSegment> soft = new ArrayList<>();
    List<BitCube> still = new ArrayList<>();
    for (Segment segment : volume.segments()) {
      ElasticMaterial material = materials.get(segment.name());
      if (material == null) {
        still.add(segment.bits());
      } else {
        soft.add(new ElasticSegment(segment.bits(), material));
      }
    }
    // Fills lie inside the segments, so they add no cells.
    double edge = edgeMm.isPresent() ? edgeMm.getAsDouble() : usualEdgeMm(metric, soft);
    soft.addAll(fills);
    return new ElasticPlan(metric, soft, still, edge, OptionalDouble.empty());
  }

  /**
   * {@return the plan with another contact}
   *
   * @param radiusMm the radius over which the force is spread, mm; if empty, two edges
   */
  public ElasticPlan withContact(OptionalDouble radiusMm) {
    return new ElasticPlan(metric, soft, still, edgeMm, radiusMm);
  }

  /** Returns the edge with which the usual number of cells covers the boxes of the segments. */
  private static double usualEdgeMm(GridMetric metric, List<ElasticSegment> soft) {
    double voxels = 0;
    for (ElasticSegment segment : soft) {
      IntBox box = segment.bits().bounds();
      if (!box.isEmpty()) {
        double layer = (double) (box.highX - box.lowX + 1) * (box.highY - box.lowY + 1);
        voxels += layer * (box.highZ - box.lowZ + 1);
      }
    }
    double mm3 = voxels * metric.spacingX() * metric.spacingY() * metric.spacingZ();
    return Math.max(metric.shortestEdgeMm(), Math.cbrt(mm3 / USUAL_CELLS));
  }

  /**
   * Makes a body at rest.
   *
   * @throws IllegalArgumentException as {@link ControlLattice}
   */
  @Override
  public ElasticBody get() {
    return new ElasticBody(
        new ControlLattice(metric, soft, still, edgeMm, contactRadiusMm), metric);
  }
}
