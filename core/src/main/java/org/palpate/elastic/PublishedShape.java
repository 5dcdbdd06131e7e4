package org.palpate.elastic;

import java.util.Optional;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.Vec3;
import org.palpate.sync.Accumulator;
import org.palpate.sync.PositionProperty;

/**
 * The shape of an elastic body for one reader of the published frames, for example a scene. It is
 * that of the newest field for the point and the force of the last frame that the reader took.
 *
 * <p>The haptic thread calls {@link #setFrame}, the thread of the updates {@link #offer}, and the
 * reader the other methods. No thread waits for another.
 */
public final class PublishedShape {
  private final ElasticContact contact;
  private final LatticeLayout layout;
  private final FieldExchange fields;
  private final DeformationMap map;
  private final PositionProperty point;
  private final PositionProperty forceNewton;
  private final Vec3 scratch = new Vec3();

  /**
   * Makes the properties of a shape.
   *
   * @param accumulator that of the reader, before its first publication
   */
  PublishedShape(ElasticContact contact, DeformationField.Layout layout, Accumulator accumulator) {
    this.contact = contact;
    this.layout = layout.whole();
    fields = new FieldExchange(layout);
    map = new DeformationMap(layout, fields.front());
    point = accumulator.position("material point");
    forceNewton = accumulator.position("force on the material");
  }

  /** Sets what the last frame left; the publication of the frame must follow. Haptic thread. */
  public void setFrame() {
    point.set(contact.position());
    forceNewton.set(contact.load().forceNewton);
  }

  /** Hands a copy of a proved field over. Thread of the updates. */
  void offer(DeformationField field) {
    fields.back().set(field);
    fields.publish();
  }

  /**
   * Takes the newest field, and point and force of the frame that the reader took last.
   *
   * @return whether the shape differs from the last one
   */
  public boolean take() {
    boolean slid = point.isDirty() && fields.front().slideIntervals > 0;
    boolean differs = fields.hasNew() || forceNewton.isDirty() || slid;
    if (differs) {
      fields.take();
      map.use(fields.front());
      map.slideTo(point.read(scratch));
      forceNewton.read(scratch);
      map.setForce(scratch.x, scratch.y, scratch.z);
    }
    return differs;
  }

  /** {@return the layout of the lattice} Any thread. */
  public LatticeLayout layout() {
    return layout;
  }

  /**
   * {@return the layout of the window, if the shape has one now} Its place in the grid is not that
   * of this shape; {@link #windowOrigin} writes that.
   */
  public Optional<LatticeLayout> windowLayout() {
    return map.field().hasWindow()
        ? Optional.of(map.field().window.nodes().layout())
        : Optional.empty();
  }

  /**
   * Writes the first node of the window. The shape must have one now.
   *
   * @param dest receives the node, grid coordinates at rest
   * @return {@code dest}
   */
  public Vec3 windowOrigin(Vec3 dest) {
    for (int axis = 0; axis < 3; axis++) {
      int voxels = map.field().window.firstCell[axis] * layout.voxelsPerCell(axis);
      dest.set(axis, layout.originVoxel(axis) + voxels);
    }
    return dest;
  }

  /**
   * Writes the interaction point of the last frame.
   *
   * @param dest receives the point, material coordinates
   * @return {@code dest}
   */
  public Vec3 materialPoint(Vec3 dest) {
    return point.read(dest);
  }

  /**
   * Writes the present position of a material point.
   *
   * @param material the point, material coordinates
   * @param dest receives the position, grid coordinates; may be {@code material}
   * @return {@code dest}
   */
  public Vec3 present(Vec3 material, Vec3 dest) {
    return map.forward(material, dest);
  }

  /**
   * Writes the displacement of every node, mm along the axes of the grid.
   *
   * @param dest three numbers for each node, in the order of their numbers
   */
  public void displacementsMm(float[] dest) {
    for (int node = 0; node < layout.nodeCount(); node++) {
      for (int axis = 0; axis < 3; axis++) {
        double cells = map.displacement(node, axis);
        dest[3 * node + axis] = (float) (cells * layout.edgeMm(axis));
      }
    }
  }

  /**
   * Writes the displacement of every node of the window, as {@link #displacementsMm}. The shape
   * must have one now.
   *
   * @param dest three numbers for each node, in the order of their numbers
   */
  public void windowDisplacementsMm(float[] dest) {
    LatticeLayout inWindow = map.field().window.nodes().layout();
    for (int node = 0; node < inWindow.nodeCount(); node++) {
      for (int axis = 0; axis < 3; axis++) {
        double cells = map.windowDisplacement(node, axis);
        dest[3 * node + axis] = (float) (cells * inWindow.edgeMm(axis));
      }
    }
  }
}
