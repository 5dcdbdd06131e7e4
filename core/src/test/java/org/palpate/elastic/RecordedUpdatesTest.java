package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.edit.BrushEdit;
import org.palpate.elastic.lattice.CellStiffness;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;

/** Lets updates come at random times, as in a live session, and computes them again. */
class RecordedUpdatesTest {
  private static final int FRAMES = 1500;

  private final Random random = new Random(Seeds.seed());
  private final List<RecordedUpdate> recorded = new ArrayList<>();

  private OptionalDouble radiusMm = OptionalDouble.empty();

  private ElasticTouch touch() {
    return new ElasticTouch(
        ElasticTouch.Scene.block(new GridMetric(1, 1, 1)),
        20e3,
        ForceSettings.of(0.5, 0),
        8,
        radiusMm,
        true);
  }

  /** Keeps updates in the order of the session, with the frame that used each. */
  private final class Keeper implements UpdateListener {
    private final List<RecordedUpdate.Refill> refills = new ArrayList<>();
    private long frame;

    @Override
    public void refilled(int cell, CellStiffness stiffness) {
      refills.add(new RecordedUpdate.Refill(cell, stiffness));
    }

    @Override
    public void updating(Vec3 point, Vec3 forceNewton) {
      recorded.add(
          new RecordedUpdate(
              RecordedUpdate.UNUSED,
              new Vec3().set(point),
              new Vec3().set(forceNewton),
              List.copyOf(refills)));
      refills.clear();
    }

    @Override
    public void used(long update) {
      RecordedUpdate row = recorded.get((int) update);
      recorded.set(
          (int) update, new RecordedUpdate(frame, row.point(), row.forceNewton(), row.refills()));
    }
  }

  private static void moveHand(ElasticTouch touch, int n) {
    touch.hand.set(48.3 + 9 * Math.sin(0.004 * n), 48.4, 47 + 5 * Math.cos(0.011 * n));
    if (n % 200 == 150) {
      touch.edits.offer(new BrushEdit(0, new Vec3(48 + n % 7, 48, 46), 2.5, false));
    }
  }

  /** Returns the material coordinates of the point after each frame of a session. */
  private List<Vec3> session() {
    ElasticTouch touch = touch();
    Keeper keeper = new Keeper();
    touch.body.listen(keeper);
    List<Vec3> positions = new ArrayList<>();
    ElasticLoad load = new ElasticLoad();
    for (int n = 0; n < FRAMES; n++) {
      if (random.nextInt(30) == 0) {
        touch.body.updater().update(load); // of frames before
        if (random.nextInt(4) == 0) {
          touch.body.updater().update(load); // replaces a field that nobody used
        }
      }
      if (random.nextInt(20) == 0) {
        touch.body.loads().read(load);
      }
      keeper.frame = n;
      moveHand(touch, n);
      touch.runWithoutUpdate();
      positions.add(new Vec3().set(touch.frame.point().position));
    }
    return positions;
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aReplayWithTheRecordedUpdatesGivesTheSameBits(boolean windowed) {
    radiusMm = windowed ? OptionalDouble.of(8) : OptionalDouble.empty();
    List<Vec3> live = session();
    assertTrue(recorded.stream().anyMatch(r -> !r.refills().isEmpty()), "edits are recorded");
    assertTrue(recorded.stream().anyMatch(r -> r.frame() == RecordedUpdate.UNUSED), "some unused");
    ElasticTouch touch = touch();
    RecordedUpdates updates = new RecordedUpdates(touch.body, recorded);
    int moved = 0;
    for (int n = 0; n < FRAMES; n++) {
      updates.beforeFrame();
      moveHand(touch, n);
      touch.runWithoutUpdate();
      Vec3 position = touch.frame.point().position;
      assertTrue(position.sameBits(live.get(n)), "frame " + n + ": " + position);
      moved += n > 0 && !position.sameBits(live.get(n - 1)) ? 1 : 0;
    }
    assertTrue(moved > FRAMES / 2, "moved " + moved);
    assertTrue(touch.body.counters().updates() > 20);
    assertEquals(0, touch.body.counters().elsewhere());
    assertEquals(windowed, touch.body.contact().map().field().hasWindow());
  }

  @Test
  void aLoadThatNoFrameReachesIsElsewhere() {
    session();
    int last = recorded.size() - 1;
    while (recorded.get(last).frame() == RecordedUpdate.UNUSED) {
      last--;
    }
    RecordedUpdate row = recorded.get(last);
    Vec3 place = row.point();
    Vec3 force = row.forceNewton();
    Vec3 otherPlace = new Vec3(place.x, place.y, Math.nextUp(place.z));
    Vec3 otherForce = new Vec3(force.x, force.y, Math.nextUp(force.z));
    recorded.set(last, new RecordedUpdate(row.frame(), otherPlace, force, row.refills()));
    assertEquals(1, elsewhere());
    recorded.set(last, new RecordedUpdate(row.frame(), place, otherForce, row.refills()));
    assertEquals(1, elsewhere());
    recorded.set(last, row);
    assertEquals(0, elsewhere());
  }

  /** Replays the session and returns the number of loads that the replay did not reach. */
  private long elsewhere() {
    ElasticTouch touch = touch();
    RecordedUpdates updates = new RecordedUpdates(touch.body, recorded);
    for (int n = 0; n < FRAMES; n++) {
      updates.beforeFrame();
      moveHand(touch, n);
      touch.runWithoutUpdate();
    }
    return touch.body.counters().elsewhere();
  }

  @Test
  void aReplayWithOtherUpdatesGivesOtherBits() {
    List<Vec3> live = session();
    ElasticTouch touch = touch();
    int different = 0;
    for (int n = 0; n < FRAMES; n++) {
      moveHand(touch, n);
      touch.run();
      different += touch.frame.point().position.sameBits(live.get(n)) ? 0 : 1;
    }
    assertTrue(different > FRAMES / 4, "different " + different);
  }

  @Test
  void refusesCellsOfAnotherLattice() {
    ElasticTouch touch = touch();
    int cells = touch.body.hexahedra();
    new RecordedUpdates(touch.body, List.of(updateOf(cells - 1)));
    for (int cell : new int[] {-1, cells}) {
      IllegalArgumentException thrown =
          assertThrows(
              IllegalArgumentException.class,
              () -> new RecordedUpdates(touch.body, List.of(updateOf(cell))));
      assertEquals(
          "an update sets cell " + cell + ", but cells are 0 to " + (cells - 1),
          thrown.getMessage());
    }
  }

  private static RecordedUpdate updateOf(int cell) {
    RecordedUpdate.Refill refill =
        new RecordedUpdate.Refill(cell, new CellStiffness(1, 1, 1, 1, 1));
    return new RecordedUpdate(0, new Vec3(), new Vec3(), List.of(refill));
  }
}
