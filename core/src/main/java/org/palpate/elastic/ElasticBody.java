package org.palpate.elastic;

import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.geometry.GridMetric;
import org.palpate.sync.Accumulator;

/**
 * The elastic segments of a scene: their lattice, the contact for the haptic thread, and what
 * computes updates.
 *
 * <p>One body serves one session or one replay, because it keeps its present shape.
 */
public final class ElasticBody {
  private final ControlLattice lattice;
  private final DeformationField.Layout layout;
  private final ElasticContact contact;
  private final FieldUpdater updater;
  private final ElasticLoad.Exchange loads = new ElasticLoad.Exchange();

  /**
   * Creates a body at rest.
   *
   * @param lattice belongs to the body from now on
   * @param metric the spacing of the grid
   */
  public ElasticBody(ControlLattice lattice, GridMetric metric) {
    this(lattice, metric, FieldUpdater.Settings.usual(lattice));
  }

  /** Creates a body at rest with other settings; otherwise as the other constructor. */
  ElasticBody(ControlLattice lattice, GridMetric metric, FieldUpdater.Settings settings) {
    this.lattice = lattice;
    layout = DeformationField.Layout.of(lattice);
    FieldExchange fields = new FieldExchange(layout);
    ChangedCells changed = new ChangedCells(lattice);
    contact = new ElasticContact(layout, metric, fields, loads, changed);
    updater = new FieldUpdater(lattice, layout, settings, fields, changed);
  }

  /** {@return the contact, which belongs to the haptic thread} */
  public ElasticContact contact() {
    return contact;
  }

  /**
   * Sets the listener that receives the inputs of all updates, for a recording. Call it before the
   * first frame and the first update.
   *
   * @param listener receives them in the threads that {@link UpdateListener} names
   */
  public void listen(UpdateListener listener) {
    contact.listen(listener);
    updater.listen(listener);
  }

  /** {@return the number of finite elements, with those of a window around the contact} */
  public int hexahedra() {
    int inWindow = lattice.window().map(window -> window.matter().cells().count()).orElse(0);
    return lattice.cells().count() + inWindow;
  }

  /** {@return the number of voxels that give way but that a tool cannot touch} */
  public long untouchableVoxels() {
    return lattice.untouchableVoxels();
  }

  /**
   * {@return the number of parts that edits have cut off from all support} Such parts stand still.
   * Read it after the last update.
   */
  public int freeParts() {
    return lattice.freeParts();
  }

  /** {@return the counters of the updates; read them after the last one} */
  public UpdateCounters counters() {
    return updater.counters();
  }

  /**
   * {@return the shape for a reader of frames} Call it at most once, before the first frame and the
   * first update.
   *
   * @param accumulator that of the reader, before its first publication
   */
  public PublishedShape publish(Accumulator accumulator) {
    PublishedShape shape = new PublishedShape(contact, layout, accumulator);
    updater.publishTo(shape);
    return shape;
  }

  /** Returns an update with the newest load of the haptic thread. */
  Runnable liveUpdate() {
    ElasticLoad load = new ElasticLoad();
    return () -> {
      loads.read(load);
      updater.update(load);
    };
  }

  FieldUpdater updater() {
    return updater;
  }

  ElasticLoad.Exchange loads() {
    return loads;
  }

  ControlLattice lattice() {
    return lattice;
  }
}
