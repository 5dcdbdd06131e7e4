package org.palpate.rigid;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.rigid.Mover.EditOutcome;
import org.palpate.rigid.tool.RigidTool;

/**
 * A tool and bodies as rigid things that move by verified motions. Each pair of which at least one
 * can move has one {@link BodyVerifier}, whose state stays, whoever moves or is held.
 *
 * <p>The tool carries the sample points of its pairs. Of two bodies the one with fewer sample
 * points carries them, and the first of two with as many. Bodies are numbered as in their scene;
 * the tool comes last.
 *
 * <p>Haptic thread only. Creating a scene or a solver for it allocates; frames do not.
 */
public final class RigidScene {
  private final BodyScene bodies;
  private final RigidSettings settings;
  private final Mover[] movers;
  private final MoverVerifier[] verifiers;
  private final BodyVerifier[][] pairs;
  private final MoverBroadPhase broadPhase;
  private final BodyMover bodyMover;
  private final Map<LevelsKey, ClearanceLevels> levels = new HashMap<>();
  private final ClearanceLevels[] allLevels;
  private final Map<ClearanceLevels, ContactField> fields = new HashMap<>();

  /** All pairs of which one may enclose the other, in the order in which they are examined. */
  private final List<BodyVerifier> examined = new ArrayList<>();

  private int nextExamined;

  /** The number of edits of all bodies that {@link #takeEdits} has seen. */
  private long editsSeen;

  private int mostReduced;

  /** Two bodies overlap of which one can move, so that no motion could be verified. */
  public static final class BodiesOverlapException extends IllegalArgumentException {
    private static final long serialVersionUID = 1;

    private BodiesOverlapException(String one, String other) {
      super("the bodies " + one + " and " + other + " overlap");
    }
  }

  /** Pairs in which the same body keeps the same clearance share its grown solids. */
  private record LevelsKey(int body, Clearance clearance) {}

  /**
   * Creates a scene. The tool is not placed yet.
   *
   * @param bodies the bodies at their present poses
   * @param tool the sample points of the tool
   * @param shapes the sample points of the bodies that move
   * @param settings the clearances of the tool, grey values, and whether to skip
   * @throws BodiesOverlapException if two bodies of which one can move overlap
   */
  public RigidScene(
      BodyScene bodies, RigidTool tool, MovableShapes shapes, RigidSettings settings) {
    this.bodies = bodies;
    this.settings = settings;
    int count = bodies.count();
    movers = new Mover[count + 1];
    for (int n = 0; n < count; n++) {
      RigidTool shape = shapes.shapes().get(n);
      Body body = bodies.body(n);
      movers[n] = shape == null ? Mover.standing(body) : Mover.moving(body, shape);
    }
    movers[count] = Mover.tool(tool);
    pairs = new BodyVerifier[count + 1][count + 1];
    addPairs(shapes);
    allLevels = levels.values().toArray(new ClearanceLevels[0]);
    double edgeMm = bodies.shortestEdgeMm();
    broadPhase = new MoverBroadPhase(movers, growthVoxels(), edgeMm, settings.skips());
    verifiers = new MoverVerifier[count + 1];
    for (int n = 0; n <= count; n++) {
      if (movers[n].canMove()) {
        StepLimits limits = new StepLimits(edgeMm);
        verifiers[n] =
            new MoverVerifier(movers[n], pairs[n], fields(n), broadPhase, limits, settings.skips());
      }
    }
    bodyMover = new BodyMover(this);
    editsSeen = bodies.edits();
    noteReduced();
  }

  /** Returns the number of voxels by which grown solids of each body reach beyond a voxel. */
  private int[] growthVoxels() {
    int[] most = new int[bodies.count()];
    levels.forEach((key, grown) -> most[key.body] = Math.max(most[key.body], grown.reachVoxels()));
    return most;
  }

  private void addPairs(MovableShapes shapes) {
    Clearance[] fromTool = settings.clearancesOf(bodies);
    for (int a = 0; a < bodies.count(); a++) {
      addPair(toolIndex(), a, fromTool[a]);
      for (int b = 0; b < a; b++) {
        if (movers[a].canMove() || movers[b].canMove()) {
          int points = carriesPoints(b, a) ? b : a;
          int solid = points == a ? b : a;
          Clearance clearance = shapes.clearance(movers[points].shape, bodies.body(solid));
          addPair(points, solid, clearance);
          requireApart(pairs[a][b]);
        }
      }
    }
  }

  /** Whether the first of two bodies carries the points. */
  private boolean carriesPoints(int first, int second) {
    RigidTool a = movers[first].shape;
    RigidTool b = movers[second].shape;
    return b == null || (a != null && a.count() <= b.count());
  }

  private void addPair(int points, int solid, Clearance clearance) {
    ClearanceLevels grown =
        levels.computeIfAbsent(
            new LevelsKey(solid, clearance),
            key -> new ClearanceLevels(bodies.body(solid), clearance, settings.device()));
    fields.computeIfAbsent(grown, key -> new ContactField(grown, settings.grey(solid)));
    BodyVerifier pair = new BodyVerifier(movers[points], movers[solid], grown, settings.skips());
    pairs[points][solid] = pair;
    pairs[solid][points] = pair;
    if (pair.enclosure().canEnclose()) {
      examined.add(pair);
    }
  }

  private static void requireApart(BodyVerifier pair) {
    boolean apart =
        pair.place(pair.points.pose, pair.solid.bodyPose(), 0)
            && !pair.enclosure().enclosesAny(pair.points.pose, pair.solid.bodyPose());
    pair.enclosure().beginOrEnd();
    if (!apart) {
      throw new BodiesOverlapException(pair.points.body.name(), pair.solid.body.name());
    }
  }

  /** {@return the bodies} */
  public BodyScene bodies() {
    return bodies;
  }

  BodyMover bodyMover() {
    return bodyMover;
  }

  RigidSettings settings() {
    return settings;
  }

  int toolIndex() {
    return bodies.count();
  }

  /** Returns the verifier of a mover by its index; null for a body that stands still. */
  MoverVerifier verifier(int mover) {
    return verifiers[mover];
  }

  Mover mover(int index) {
    return movers[index];
  }

  /** Returns the verifier of two movers; null if neither can move. */
  BodyVerifier pair(int one, int other) {
    return pairs[one][other];
  }

  /**
   * Checks that a body can move.
   *
   * @throws IllegalArgumentException if it stands still
   */
  void requireMovable(int body) {
    if (verifiers[body] == null) {
      throw new IllegalArgumentException("the body stands still: " + bodies.body(body).name());
    }
  }

  /** Returns the surface of each pair of a mover, by the index of the other. */
  private ContactField[] fields(int mover) {
    ContactField[] ofMover = new ContactField[pairs.length];
    for (int n = 0; n < ofMover.length; n++) {
      BodyVerifier pair = pairs[mover][n];
      ofMover[n] = pair == null ? null : fields.get(pair.levels);
    }
    return ofMover;
  }

  /** Whether somebody else set the pose of a body, so that its motion was not verified. */
  boolean wasBodyMoved() {
    for (Mover mover : movers) {
      if (mover.wasMoved()) {
        return true;
      }
    }
    return false;
  }

  /**
   * Takes the poses of all bodies as they are, unverified. The tool must be placed anew. If a
   * sample point of one body touches a voxel of another, neither moves until a pose or an edit
   * parts them.
   */
  void takeBodyPoses() {
    for (Mover mover : movers) {
      if (mover.wasMoved()) {
        mover.takeBodyPose();
      }
    }
    for (int a = 0; a < bodies.count(); a++) {
      for (int b = 0; b < a; b++) {
        BodyVerifier pair = pairs[a][b];
        if (pair != null) {
          pair.place(pair.points.pose, pair.solid.bodyPose(), -1);
          pair.enclosure().begin();
        }
      }
    }
    noteReduced();
  }

  /**
   * Applies the edits of bodies to all grown solids. Otherwise edits would pile up in frames
   * without a motion, and the next motion would have to grow whole bodies anew.
   */
  void growEdits() {
    for (ClearanceLevels grown : allLevels) {
      grown.takeEdits();
    }
  }

  /**
   * Applies the edits of bodies to all pairs of bodies. If an added voxel touches a sample point of
   * a pair, both bodies stay where they are, because every leg of that point would touch it.
   */
  void takeEdits() {
    long edits = bodies.edits();
    if (edits == editsSeen) {
      return;
    }
    editsSeen = edits;
    for (int a = 0; a < bodies.count(); a++) {
      for (int b = 0; b < a; b++) {
        if (pairs[a][b] != null && pairs[a][b].takeEdits() == EditOutcome.FREE) {
          pairs[a][b].enclosure().begin();
        }
      }
    }
    noteReduced();
  }

  /** Notes how many points of bodies keep less than their clearance; a motion makes them fewer. */
  private void noteReduced() {
    int sum = 0;
    for (int a = 0; a < bodies.count(); a++) {
      for (int b = 0; b < a; b++) {
        sum += pairs[a][b] == null ? 0 : pairs[a][b].reducedCount();
      }
    }
    mostReduced = Math.max(mostReduced, sum);
  }

  /** Returns the most points of bodies that kept less than their clearance from other bodies. */
  int mostReducedPoints() {
    return mostReduced;
  }

  /**
   * Continues the {@link EnclosureCheck} of one pair. The pairs take turns, so that a pair whose
   * check never ends, because its solid stays enclosed, does not stop the checks of the others.
   */
  void continueEnclosureCheck() {
    if (!isCheckPending()) {
      return;
    }
    for (int n = 0; n < examined.size(); n++) {
      BodyVerifier pair = examined.get(nextExamined);
      nextExamined = nextExamined + 1 < examined.size() ? nextExamined + 1 : 0;
      if (pair.isPresent() && pair.enclosure().canContinue()) {
        pair.enclosure().continueCheck();
        return;
      }
    }
  }

  private boolean isCheckPending() {
    for (Mover mover : movers) {
      if (mover.pendingChecks > 0) {
        return true;
      }
    }
    return false;
  }
}
