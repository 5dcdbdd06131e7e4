package org.palpate.benchmarks.stress;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.BorderVoxels;
import org.palpate.proxy.reference.DotSolver;
import org.palpate.proxy.reference.PaperSolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.GridPlanesRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.raycast.SampledRayCaster;

/**
 * Measures what other methods lose in the same hostile cases. It counts the rays on which a
 * collision test misses a solid. For each solver it counts the legs and frames that touch a solid,
 * and measures how deep the point ends. The device positions are those of the guarded solver's run.
 */
public final class BaselineLosses {
  private static final double SAMPLED_STEP = 1;
  private static final double FINE_STEP = 0.1;

  private final List<CasterLoss> casters =
      List.of(
          new CasterLoss("sampled:1", new SampledRayCaster(SAMPLED_STEP)),
          new CasterLoss("sampled:0.1", new SampledRayCaster(FINE_STEP)),
          new CasterLoss("gridplanes", new GridPlanesRayCaster()),
          new CasterLoss("exact", new ExactRayCaster()));
  private final List<SolverLoss> solvers = new ArrayList<>();
  private final long seed;

  /** Creates a measurement over the cases of a seed. */
  public BaselineLosses(long seed) {
    this.seed = seed;
    RayCaster sampled = new SampledRayCaster(SAMPLED_STEP);
    RayCaster fine = new SampledRayCaster(FINE_STEP);
    RayCaster planes = new GridPlanesRayCaster();
    BorderVoxels border = BorderVoxels.onTheFly();
    add("dot, sampled:1", (metric, step) -> new DotSolver(sampled, metric, step, border));
    add("paper, sampled:1", (metric, step) -> new PaperSolver(sampled, metric, step, border));
    add("paper, sampled:0.1", (metric, step) -> new PaperSolver(fine, metric, step, border));
    add("paper, gridplanes", (metric, step) -> new PaperSolver(planes, metric, step, border));
    add("guarded", GuardedSolver::new);
  }

  private void add(String name, SolverFactory factory) {
    solvers.add(new SolverLoss(name, factory));
  }

  /** Runs a number of cases. */
  public void run(int cases) {
    for (int n = 0; n < cases; n++) {
      StressCase stress = new StressCase(StressRun.caseSeed(seed, n));
      ProxySolver guarded = new GuardedSolver(stress.scene.metric(), stress.scene.maxStepMm());
      List<Vec3> devices = stress.devices(guarded, StressCase.FRAMES);
      casters.forEach(caster -> caster.run(stress, devices));
      solvers.forEach(solver -> solver.run(stress, devices));
    }
  }

  /** Returns the number of hits that a collision test missed. */
  public long missed(String caster) {
    return casters.stream().filter(c -> c.name.equals(caster)).findFirst().orElseThrow().missed;
  }

  /** Returns the number of a solver's legs that touch a solid. */
  public long badLegs(String solver) {
    return solvers.stream().filter(s -> s.name.equals(solver)).findFirst().orElseThrow().badLegs;
  }

  /** Prints both tables as Markdown. */
  public void print(PrintWriter out) {
    out.println("| collision | rays that touch a solid | missed | fraction |");
    out.println("| --- | --- | --- | --- |");
    casters.forEach(caster -> caster.print(out));
    out.println();
    out.println(
        "| solver | frames | legs | frames in violation | legs in violation | deepest end |");
    out.println("| --- | --- | --- | --- | --- | --- |");
    solvers.forEach(solver -> solver.print(out));
    out.flush();
  }

  /** One collision test against the exact judge, on rays between successive device positions. */
  private static final class CasterLoss {
    private final String name;
    private final RayCaster caster;
    private final ExactJudge judge = new ExactJudge();
    private final Ray ray = new Ray();
    private final RayHit hit = new RayHit();
    private long touching;
    private long missed;

    CasterLoss(String name, RayCaster caster) {
      this.name = name;
      this.caster = caster;
    }

    void run(StressCase stress, List<Vec3> devices) {
      Vec3 last = stress.start;
      for (Vec3 device : devices) {
        ray.from(last.x, last.y, last.z).to(device.x, device.y, device.z);
        if (judge.touches(stress.scene.bits(), ray)) {
          touching++;
          missed += caster.cast(stress.scene.bits(), ray, hit) ? 0 : 1;
        }
        last = device;
      }
    }

    void print(PrintWriter out) {
      out.printf(
          Locale.ROOT,
          "| `%s` | %d | %d | %.2f %% |%n",
          name,
          touching,
          missed,
          100.0 * missed / touching);
    }
  }

  /** One solver, judged leg by leg. */
  private static final class SolverLoss {
    private final String name;
    private final SolverFactory factory;
    private final ExactJudge judge = new ExactJudge();
    private final InteractionPoint point = new InteractionPoint();
    private long frames;
    private long legs;
    private long badFrames;
    private long badLegs;
    private double deepestVoxels;

    SolverLoss(String name, SolverFactory factory) {
      this.name = name;
      this.factory = factory;
    }

    void run(StressCase stress, List<Vec3> devices) {
      ProxySolver solver = factory.make(stress.scene.metric(), stress.scene.maxStepMm());
      CollisionScene collisionScene = stress.collisionScene();
      point.position.set(stress.start);
      for (Vec3 device : devices) {
        solver.follow(collisionScene, device, point);
        frames++;
        legs += point.legs.count();
        int bad = countBadLegs(stress);
        badLegs += bad;
        badFrames += bad > 0 ? 1 : 0;
        if (bad > 0) {
          double depth = PenetrationDepth.voxels(stress.scene.bits(), point.position);
          deepestVoxels = Math.max(deepestVoxels, depth);
        }
      }
    }

    private int countBadLegs(StressCase stress) {
      int bad = 0;
      for (int leg = 0; leg < point.legs.count(); leg++) {
        bad += judge.touches(stress.scene.bits(), point.legs, leg) ? 1 : 0;
      }
      return bad;
    }

    void print(PrintWriter out) {
      out.printf(
          Locale.ROOT,
          "| %s | %d | %d | %d (%.2f %%) | %d (%.2f %%) | %.2f voxels |%n",
          name,
          frames,
          legs,
          badFrames,
          100.0 * badFrames / frames,
          badLegs,
          100.0 * badLegs / Math.max(1, legs),
          deepestVoxels);
    }
  }
}
