package org.palpate.elastic;

import java.util.Optional;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

/** Opens to studies what an elastic body computes inside. Thread: that of the body's frames. */
public final class ElasticBodyVariants {
  private ElasticBodyVariants() {}

  /**
   * Returns a body at rest with a contact of any radius, whose updates are as exact as wanted.
   *
   * @param contactRadiusMm radius of the patch over which the force is spread, mm
   * @param residual the force that a displacement may leave unbalanced, over its load
   */
  public static ElasticBody body(
      ControlLattice lattice, GridMetric metric, double contactRadiusMm, double residual) {
    return new ElasticBody(lattice, metric, new FieldUpdater.Settings(contactRadiusMm, residual));
  }

  /** Returns the layout of the body's lattice. */
  public static LatticeLayout layout(ElasticBody body) {
    return body.lattice().layout();
  }

  /** Returns the position along an axis of a node, in cells, as the haptic thread computes it. */
  public static double nodePosition(ElasticBody body, int node, int axis) {
    return body.contact().map().nodePosition(node, axis);
  }

  /**
   * Returns the layout of the window of the field in use, if it has one. It counts cells from the
   * lowest corner of the window, not of the lattice.
   */
  public static Optional<LatticeLayout> windowLayout(ElasticBody body) {
    DeformationField field = body.contact().map().field();
    return field.hasWindow() ? Optional.of(field.window.nodes().layout()) : Optional.empty();
  }

  /** Whether a cell of the lattice lies in the window of the field in use, which must have one. */
  public static boolean isInWindow(ElasticBody body, int x, int y, int z) {
    return body.contact().map().field().window.covers(x, y, z);
  }

  /**
   * Returns the present position of a node of the window along an axis, in cells of the window from
   * its lowest corner.
   */
  public static double windowPosition(ElasticBody body, int node, int axis) {
    DeformationMap map = body.contact().map();
    LatticeLayout layout = map.field().window.nodes().layout();
    return layout.nodeIndex(axis, node) + map.windowDisplacement(node, axis);
  }

  /** Writes the present position of a material point, grid coordinates. */
  public static void present(ElasticBody body, Vec3 material, Vec3 dest) {
    body.contact().map().forward(material, dest);
  }
}
