package org.palpate.elastic;

import java.util.Arrays;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.elastic.lattice.Vectors;
import org.palpate.geometry.Vec3;

/**
 * Computes a new field for a load: the displacement, the answers to a unit force along each axis at
 * the same place, and the proof. It starts from the last displacement and the last answers. If the
 * lattice has a window around the contact, that is solved after the lattice.
 *
 * <p>A field is handed over only if {@link RoomProof} proves it. One thread, not the haptic one;
 * allocates nothing after construction.
 */
final class FieldUpdater {
  /** A smaller force has no direction of its own, N. */
  private static final double LEAST_DIRECTED_NEWTON = 0.02;

  /** The longest change of the force to prove: this, N, plus so many times the load. */
  private static final double REACH_NEWTON = 4;

  private static final double REACH_PER_LOAD = 2.5;

  /** A field is not blended with the one before if their places are nearer, shortest cells. */
  private static final double LEAST_SLIDE_CELLS = 0.02;

  /** Nor is it blended if their places are farther apart than this, shortest cells. */
  private static final double LONGEST_SLIDE_CELLS = 1;

  /** The longest distance between two places on a slide that the proof looks at, shortest cells. */
  private static final double SLIDE_INTERVAL_CELLS = 0.25;

  /** A displacement whose length over all nodes is shorter counts as none, mm. */
  private static final double REST_MM = 1e-3;

  private final ControlLattice lattice;
  private final Settings settings;
  private final FieldExchange exchange;
  private final ChangedCells changed;
  private final LatticeLayout finest;
  private final LatticeSolution whole;

  /** The solution in the window; null if the lattice has none. */
  private final WindowSolution window;

  private final RoomProof proof;
  private final float[] proved;
  private final double[] force = new double[3];
  private final double[] forceChange = new double[3];

  /** The last field that was handed over. */
  private final DeformationField last;

  private final UpdateCounters counters = new UpdateCounters();
  private UpdateListener listener = UpdateListener.NONE;

  /** The place of the load, material coordinates. */
  private final Vec3 place = new Vec3();

  /** Receives each field too; null if nobody else reads them. */
  private PublishedShape shape;

  /** The number of the present update, from 0. */
  private long begun;

  FieldUpdater(
      ControlLattice lattice,
      DeformationField.Layout layout,
      Settings settings,
      FieldExchange exchange,
      ChangedCells changed) {
    this.lattice = lattice;
    this.settings = settings;
    this.exchange = exchange;
    this.changed = changed;
    finest = layout.finest();
    double radiusMm = settings.contactRadiusMm();
    window =
        layout
            .window()
            .map(
                nodes ->
                    new WindowSolution(
                        lattice.layout(), lattice.window().orElseThrow(), nodes, radiusMm))
            .orElse(null);
    whole =
        new LatticeSolution(
            lattice.matter(),
            lattice.newSolver(),
            window == null ? radiusMm : Math.max(radiusMm, lattice.layout().longestEdgeMm()));
    proof = new RoomProof(lattice);
    last = new DeformationField(layout);
    proved = new float[whole.displacement().length];
  }

  /** Offers each field to a further reader from now on. */
  void publishTo(PublishedShape reader) {
    shape = reader;
  }

  /** Returns what the updates counted. */
  UpdateCounters counters() {
    return counters;
  }

  /** Tells a listener about refilled cells and loads. Call it before the first update. */
  void listen(UpdateListener newListener) {
    listener = newListener;
  }

  /** Counts edited voxels, computes the field for a load, and hands it over. */
  void update(ElasticLoad next) {
    long begunNanos = System.nanoTime();
    changed.refill(listener);
    listener.updating(next.point, next.forceNewton);
    if (compute(next)) {
      counters.noteNanos(System.nanoTime() - begunNanos);
    }
  }

  /**
   * Computes the field for a load and hands it over.
   *
   * @return whether there was anything to compute
   */
  boolean compute(ElasticLoad next) {
    lattice.matter().holdFreeParts();
    whole.patch().place(next.point);
    place.set(next.point);
    boolean atRest = isAtRest(next);
    if (atRest) {
      counters.countSkipped();
    } else {
      solve(next);
    }
    begun++;
    return !atRest;
  }

  /** Whether nothing is pressed or near, and the last field has come back to rest. */
  private boolean isAtRest(ElasticLoad next) {
    return whole.patch().isEmpty()
        && next.forceNewton.length() == 0
        && Vectors.norm(whole.displacement()) < REST_MM;
  }

  private void solve(ElasticLoad next) {
    predict(next.forceNewton);
    boolean scaledBack = whole.unfold(proved); // So that rotations are those of a shape.
    counters.noteResidual(whole.solve(force, settings.residual()));
    scaledBack |= whole.unfold(proved);
    counters.count(scaledBack);
    boolean windowed = window != null && solveWindow();
    publish(windowed);
  }

  /** Solves the window around the contact. Returns whether there is matter for the force. */
  private boolean solveWindow() {
    window.place(place);
    if (window.patch().isEmpty()) {
      window.restart();
      return false;
    }
    counters.noteResidual(window.solveInside(whole, force, forceChange, settings.residual()));
    return true;
  }

  /**
   * Moves the displacement along the answers by the change of the force. Without a force the shape
   * at rest is the solution.
   */
  private void predict(Vec3 next) {
    boolean isLoaded = next.length() > 0;
    if (!isLoaded) {
      Arrays.fill(whole.displacement(), 0);
    }
    for (int axis = 0; axis < 3; axis++) {
      forceChange[axis] = next.get(axis) - force[axis];
      force[axis] = next.get(axis);
      float change = (float) forceChange[axis];
      if (change != 0 && isLoaded) {
        Vectors.add(change, whole.solution(axis), whole.displacement());
      }
    }
  }

  /** Proves the field and hands it over, or goes back to the last one. */
  private void publish(boolean windowed) {
    DeformationField field = exchange.back();
    field.update = begun;
    write(field, windowed);
    if (prove(field) || (windowed && proveWithoutWindow(field))) {
      System.arraycopy(whole.displacement(), 0, proved, 0, proved.length);
      last.set(field);
      if (shape != null) {
        shape.offer(field); // Before the haptic thread owns the field.
      }
      exchange.publish();
    } else {
      System.arraycopy(proved, 0, whole.displacement(), 0, proved.length);
      whole.clearAnswers();
      restartWindow();
      counters.countRefused();
    }
  }

  private boolean prove(DeformationField field) {
    double size = Math.sqrt(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
    field.slideIntervals = size > 0 ? slideIntervals(place, last.place) : 0;
    if (field.slideIntervals > 0) {
      field.takeEarlier(last);
    }
    beginRoom(field.room, size);
    return proof.prove(field, REACH_NEWTON + REACH_PER_LOAD * size, -size);
  }

  private boolean proveWithoutWindow(DeformationField field) {
    field.window.present = false;
    restartWindow();
    boolean isProved = prove(field);
    if (isProved) {
      counters.countWindowless();
    }
    return isProved;
  }

  private void restartWindow() {
    if (window != null) {
      window.restart();
    }
  }

  private void write(DeformationField field, boolean windowed) {
    field.place.set(place);
    System.arraycopy(force, 0, field.baseNewton, 0, force.length);
    whole.write(field.whole.values);
    if (window != null) {
      field.window.present = windowed;
    }
    if (windowed) {
      WindowNodes.round(field.whole.values);
      window.write(field);
    }
  }

  /** Returns the number of intervals in which to prove a slide, or 0 for no blend. */
  private int slideIntervals(Vec3 to, Vec3 from) {
    double squared = 0;
    for (int axis = 0; axis < 3; axis++) {
      double voxels = to.get(axis) - from.get(axis);
      double cells = voxels / finest.voxelsPerCell(axis);
      squared += cells * cells;
    }
    double cells = Math.sqrt(squared);
    boolean blended = cells >= LEAST_SLIDE_CELLS && cells <= LONGEST_SLIDE_CELLS;
    return blended ? (int) Math.ceil(cells / SLIDE_INTERVAL_CELLS) : 0;
  }

  /** Sets the axis of the room: along the force, or into the solid if there is none. */
  private void beginRoom(ForceRoom room, double sizeNewton) {
    double[] along = sizeNewton > LEAST_DIRECTED_NEWTON ? force : whole.patch().inward();
    double length = Math.sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    if (length > 0) {
      room.begin(along[0] / length, along[1] / length, along[2] / length);
    } else {
      room.begin(0, 0, -1);
    }
  }

  /**
   * Settings of the updates of an elastic body.
   *
   * @param contactRadiusMm radius of the patch over which the force is spread, mm
   * @param residual the largest unbalanced force that a displacement may leave, as a fraction of
   *     its load
   */
  record Settings(double contactRadiusMm, double residual) {
    private static final double USUAL_RESIDUAL = 1e-3;

    /** Returns the usual settings on a lattice. */
    static Settings usual(ControlLattice lattice) {
      return new Settings(lattice.contactRadiusMm(), USUAL_RESIDUAL);
    }
  }
}
