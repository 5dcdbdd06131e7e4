package org.palpate.elastic;

import java.util.Arrays;
import org.palpate.elastic.lattice.ConjugateGradients;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.StiffnessOperator;
import org.palpate.elastic.lattice.Vectors;
import org.palpate.geometry.Vec3;

/**
 * Computes a new field for a load: the displacement, the answers to a unit force along each axis at
 * the same place, and the proof. It starts from the last displacement and the last answers.
 *
 * <p>A field is handed over only if {@link RoomProof} proves it. One thread, not the haptic one;
 * allocates nothing after construction.
 */
final class FieldUpdater {
  /** The residual at which an answer is good enough, over its unit load. */
  private static final double ANSWER_RESIDUAL = 2e-2;

  /** A smaller load counts as this large, N. */
  private static final double LEAST_LOAD_NEWTON = 1e-4;

  private static final int DISPLACEMENT_STEPS = 60;
  private static final int ANSWER_STEPS = 20;

  /** A smaller force has no direction of its own, N. */
  private static final double LEAST_DIRECTED_NEWTON = 0.02;

  /** The longest change of the force to prove: this, N, plus so many times the load. */
  private static final double REACH_NEWTON = 4;

  private static final double REACH_PER_LOAD = 2.5;

  /** A field is not blended with the one before if their places are nearer than this, cells. */
  private static final double LEAST_SLIDE_CELLS = 0.02;

  /** Nor is it blended if their places are farther apart than this, cells. */
  private static final double LONGEST_SLIDE_CELLS = 1;

  /** The longest distance on a slide between two places at which the proof looks, cells. */
  private static final double SLIDE_INTERVAL_CELLS = 0.25;

  /** A displacement whose length over all nodes is shorter counts as none, mm. */
  private static final double REST_MM = 1e-3;

  private final ControlLattice lattice;
  private final UpdateSettings settings;
  private final FieldExchange exchange;
  private final ChangedCells changed;
  private final StiffnessOperator stiffness;
  private final ConjugateGradients solver;
  private final ContactPatch patch;
  private final FoldGuard guard;
  private final CrushStiffening stiffening;
  private final RoomProof proof;
  private final float[] displacement;
  private final float[] proved;
  private final float[][] answers = new float[3][];

  /** The changes by the last update: of the three answers, then of the displacement. */
  private final float[][] changes = new float[4][];

  private final float[] before;
  private final float[] load;
  private final float[] residual;
  private final double[] force = new double[3];
  private final double[] lastForce = new double[3];

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
      UpdateSettings settings,
      FieldExchange exchange,
      ChangedCells changed) {
    this.lattice = lattice;
    this.settings = settings;
    this.exchange = exchange;
    this.changed = changed;
    stiffness = lattice.stiffness();
    solver = lattice.newSolver();
    patch = new ContactPatch(lattice, settings.contactRadiusMm());
    guard = new FoldGuard(lattice.cells());
    stiffening = new CrushStiffening(lattice);
    proof = new RoomProof(lattice.cells());
    last = new DeformationField(lattice.layout());
    int size = 3 * lattice.layout().nodeCount();
    displacement = new float[size];
    proved = new float[size];
    load = new float[size];
    residual = new float[size];
    before = new float[size];
    for (int axis = 0; axis < 3; axis++) {
      answers[axis] = new float[size];
    }
    for (int n = 0; n < changes.length; n++) {
      changes[n] = new float[size];
    }
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
    lattice.holdFreeParts();
    patch.place(next.point);
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
    return patch.isEmpty()
        && next.forceNewton.length() == 0
        && Vectors.norm(displacement) < REST_MM;
  }

  private void solve(ElasticLoad next) {
    predict(next.forceNewton);
    boolean scaledBack =
        guard.unfold(displacement, proved); // So that rotations are those of a shape.
    stiffening.update(guard.determinants());
    lattice.rotate(displacement);
    solveDisplacement();
    for (int axis = 0; axis < 3; axis++) {
      solveAnswer(axis);
    }
    scaledBack |= guard.unfold(displacement, proved);
    counters.count(scaledBack);
    publish();
  }

  /**
   * Moves the displacement along the answers by the change of the force. Without a force the shape
   * at rest is the solution.
   */
  private void predict(Vec3 next) {
    boolean isLoaded = next.length() > 0;
    if (!isLoaded) {
      Arrays.fill(displacement, 0);
    }
    for (int axis = 0; axis < 3; axis++) {
      force[axis] = next.get(axis);
      float change = (float) (force[axis] - lastForce[axis]);
      if (change != 0 && isLoaded) {
        Vectors.add(change, answers[axis], displacement);
      }
      lastForce[axis] = force[axis];
    }
  }

  private void solveDisplacement() {
    Arrays.fill(load, 0);
    for (int axis = 0; axis < 3; axis++) {
      patch.addForce(axis, force[axis], load);
    }
    double size = Math.max(LEAST_LOAD_NEWTON, Vectors.norm(load));
    stiffness.force(displacement, residual);
    subtractFromLoad();
    solve(displacement, changes[3], settings.residual() * size, DISPLACEMENT_STEPS);
    counters.noteResidual(solver.residualNewton() / size);
  }

  private void solveAnswer(int axis) {
    Arrays.fill(load, 0);
    patch.addForce(axis, 1, load);
    stiffness.multiply(answers[axis], residual);
    subtractFromLoad();
    double size = Vectors.norm(load);
    if (Vectors.norm(residual) > size) { // The contact has gone elsewhere.
      Arrays.fill(answers[axis], 0);
      System.arraycopy(load, 0, residual, 0, load.length);
    }
    double goal = ANSWER_RESIDUAL * Math.max(LEAST_LOAD_NEWTON, size);
    solve(answers[axis], changes[axis], goal, ANSWER_STEPS);
  }

  /** Solves for the residual. It first goes on along the last change, as a sliding contact does. */
  private void solve(float[] solution, float[] change, double goalNewton, int mostSteps) {
    System.arraycopy(solution, 0, before, 0, before.length);
    solver.descend(change, residual, solution);
    solver.solve(residual, solution, goalNewton, mostSteps);
    for (int n = 0; n < change.length; n++) {
      change[n] = solution[n] - before[n];
    }
  }

  private void subtractFromLoad() {
    for (int n = 0; n < residual.length; n++) {
      residual[n] = load[n] - residual[n];
    }
  }

  /** Proves the field and hands it over, or goes back to the last one. */
  private void publish() {
    DeformationField field = exchange.back();
    field.update = begun;
    write(field);
    double size = Math.sqrt(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
    field.place.set(place);
    field.slideIntervals = size > 0 ? slideIntervals(place, last.place) : 0;
    if (field.slideIntervals > 0) {
      field.takeEarlier(last);
    }
    beginRoom(field.room, size);
    if (proof.prove(field, REACH_NEWTON + REACH_PER_LOAD * size, -size)) {
      System.arraycopy(displacement, 0, proved, 0, proved.length);
      last.set(field);
      if (shape != null) {
        shape.offer(field); // Before the haptic thread owns the field.
      }
      exchange.publish();
    } else {
      System.arraycopy(proved, 0, displacement, 0, proved.length);
      for (float[] answer : answers) {
        Arrays.fill(answer, 0);
      }
      counters.countRefused();
    }
  }

  /** Returns the number of intervals in which to prove a slide, or 0 for no blend. */
  private int slideIntervals(Vec3 to, Vec3 from) {
    double squared = 0;
    for (int axis = 0; axis < 3; axis++) {
      double voxels = to.get(axis) - from.get(axis);
      double cells = voxels / lattice.layout().voxelsPerCell(axis);
      squared += cells * cells;
    }
    double cells = Math.sqrt(squared);
    boolean blended = cells >= LEAST_SLIDE_CELLS && cells <= LONGEST_SLIDE_CELLS;
    return blended ? (int) Math.ceil(cells / SLIDE_INTERVAL_CELLS) : 0;
  }

  private void write(DeformationField field) {
    int nodes = lattice.layout().nodeCount();
    for (int axis = 0; axis < 3; axis++) {
      float cellsPerMm = (float) (1 / lattice.layout().edgeMm(axis));
      for (int node = 0; node < nodes; node++) {
        int from = axis * nodes + node;
        int to = DeformationField.STRIDE * node + axis;
        field.values[to] = displacement[from] * cellsPerMm;
        field.values[to + 3] = answers[0][from] * cellsPerMm;
        field.values[to + 6] = answers[1][from] * cellsPerMm;
        field.values[to + 9] = answers[2][from] * cellsPerMm;
      }
      field.baseNewton[axis] = force[axis];
    }
  }

  /** Sets the axis of the room: along the force, or into the solid if there is none. */
  private void beginRoom(ForceRoom room, double sizeNewton) {
    double[] along = sizeNewton > LEAST_DIRECTED_NEWTON ? force : patch.inward();
    double length = Math.sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    if (length > 0) {
      room.begin(along[0] / length, along[1] / length, along[2] / length);
    } else {
      room.begin(0, 0, -1);
    }
  }
}
