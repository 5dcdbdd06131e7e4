package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.benchmarks.stress.FailedCase;
import org.palpate.benchmarks.stress.SolverFactory;
import org.palpate.benchmarks.stress.StressRun;
import org.palpate.benchmarks.stress.StressTotals;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.BorderVoxels;
import org.palpate.proxy.reference.PaperSolver;
import org.palpate.raycast.Ray;
import org.palpate.raycast.SampledRayCaster;
import org.palpate.testing.ExactOracle;
import org.palpate.testing.LegJudge;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/**
 * A failing case of the attack is saved in files that {@code replay} reads, and fails there too.
 */
class FailedCaseReplayTest {
  private static final long ENOUGH_FRAMES = 1_000_000;

  @TempDir private Path folder;

  @Test
  void aCaseThatBreaksThePaperSolverBreaksItInReplayToo() throws IOException {
    SolverFactory paper =
        judgedByLegs(
            (metric, maxStepMm) ->
                new PaperSolver(
                    new SampledRayCaster(1), metric, maxStepMm, BorderVoxels.onTheFly()));
    attack(paper).write(folder, "paper");
    BitCube bits = solids();
    assertTrue(touchingLegs(bits, "paper") > 0, "the saved case does not fail");
    assertTrue(touchingLegs(bits, "guarded") == 0, "guarded breaks on the saved case");
  }

  @Test
  void aCaseThatBreaksAnInjectedFaultBreaksItFromItsFilesToo() throws IOException {
    FailedCase failed = attack(judgedByLegs(LeapingSolver::new));
    failed.write(folder, "guarded");
    assertTrue(failed.scene().bits().solidCount() <= 4, failed.summary());
    BitCube bits = solids();
    GridMetric metric = GridMetric.of(failed.scene().spacingMm());
    assertNotNull(fault(bits, new LeapingSolver(metric, failed.scene().maxStepMm())));
    assertTrue(touchingLegs(bits, "guarded") == 0, "guarded breaks on the saved case");
  }

  private static FailedCase attack(SolverFactory factory) {
    FailedCase failed =
        new StressRun(Seeds.seed(), factory)
            .untilFrames(new StressTotals(), ENOUGH_FRAMES, now -> {});
    assertNotNull(failed, "the attack found nothing");
    return failed;
  }

  /** Returns a factory whose solver is checked only for the guarantee. */
  private static SolverFactory judgedByLegs(SolverFactory solver) {
    return new SolverFactory() {
      @Override
      public ProxySolver make(GridMetric metric, double maxStepMm) {
        return solver.make(metric, maxStepMm);
      }

      @Override
      public boolean endsNearer() {
        return false;
      }

      @Override
      public int framesToSettle() {
        return Integer.MAX_VALUE;
      }
    };
  }

  private BitCube solids() throws IOException {
    return SegmentBuilder.read(
            VolumeFiles.open(folder.resolve("scene.nrrd"), ReadOptions.defaults()),
            List.of(SegmentSpec.parse("solid=nonzero")))
        .segments()
        .get(0)
        .bits();
  }

  /** Runs the saved command with a solver and returns the number of legs that touch a solid. */
  private int touchingLegs(BitCube bits, String solver) throws IOException {
    List<Object> arguments = new ArrayList<>();
    String[] saved = Files.readString(folder.resolve("replay.txt")).trim().split(" ", -1);
    for (String word : Arrays.copyOfRange(saved, 1, saved.length)) {
      arguments.add(word.endsWith(".nrrd") || word.endsWith(".csv") ? folder.resolve(word) : word);
    }
    assertTrue(arguments.contains("--raw-device"), arguments.toString());
    arguments.set(arguments.indexOf("--solver") + 1, solver);
    CommandRun.of(arguments.toArray()).mustSucceed();
    int touching = 0;
    for (double[] row : rows("legs.csv")) {
      Ray leg = new Ray().from(row[2], row[3], row[4]).to(row[5], row[6], row[7]);
      assertFalse(row[1] < 0, "the start is free");
      touching += ExactOracle.touchesAny(bits, leg) ? 1 : 0;
    }
    return touching;
  }

  private List<double[]> rows(String name) throws IOException {
    return Files.readAllLines(folder.resolve(name)).stream()
        .skip(1)
        .map(line -> Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray())
        .toList();
  }

  private String fault(BitCube bits, ProxySolver solver) throws IOException {
    CollisionScene scene = new CollisionScene(List.of(bits));
    InteractionPoint point = new InteractionPoint();
    LegJudge judge = null;
    for (double[] row : rows("device.csv")) {
      Vec3 device = new Vec3(row[1], row[2], row[3]);
      if (judge == null) {
        point.position.set(device);
        judge = new LegJudge(bits, device);
      }
      solver.follow(scene, device, point);
      String fault = judge.faultOf(point);
      if (fault != null) {
        return fault;
      }
    }
    return null;
  }

  /** The guarded solver with a fault: in the third frame of a contact it jumps to the device. */
  private static final class LeapingSolver implements ProxySolver {
    private final GuardedSolver guarded;
    private int contacts;

    LeapingSolver(GridMetric metric, double maxStepMm) {
      guarded = new GuardedSolver(metric, maxStepMm);
    }

    @Override
    public void follow(CollisionScene scene, Vec3 device, InteractionPoint point) {
      guarded.follow(scene, device, point);
      contacts = point.contact ? contacts + 1 : 0;
      if (contacts == 3) {
        Vec3 p = point.position;
        point.legs.add(p.x, p.y, p.z, device.x, device.y, device.z, 0, false);
        p.set(device);
      }
    }
  }
}
