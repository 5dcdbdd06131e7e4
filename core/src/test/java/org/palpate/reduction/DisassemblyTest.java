package org.palpate.reduction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.reduction.Disassembly.Exit;
import org.palpate.rigid.MovableShapes;
import org.palpate.volume.BitCube;

class DisassemblyTest {
  private static final BitCube LID = PullSearchTest.box(6, 6, 12, 10, 10, 16);

  @Test
  void whatLiesOnTopComesOutFirst() {
    Pose aside = Pose.at(0, 40, 0);
    List<Exit> exits =
        exits(
            body("block", BlockWithHole.bits(), Mobility.FIXED, new Pose()),
            body("peg", BlockWithHole.PEG, Mobility.MOVABLE, aside),
            body("lid", LID, Mobility.MOVABLE, Pose.at(0, -40, 0)));
    assertEquals(List.of(2, 1), exits.stream().map(Exit::fragment).toList());
    assertTrue(exits.stream().allMatch(exit -> exit.pulled().isOut()), exits.toString());
    assertEquals(List.of(1, 2), exits.get(0).among());
    assertEquals(List.of(1), exits.get(1).among());
  }

  @Test
  void aFragmentThatLiesInThePlaceOfAnotherComesOutAfterIt() {
    List<Exit> exits =
        exits(
            body("one", PullSearchTest.box(0, 0, 0, 4, 4, 4), Mobility.MOVABLE, Pose.at(9, 1, 0)),
            body(
                "other",
                PullSearchTest.box(10, 0, 0, 14, 4, 4),
                Mobility.MOVABLE,
                Pose.at(0, 30, 0)));
    assertEquals(List.of(1, 0), exits.stream().map(Exit::fragment).toList());
  }

  /** The fracture left the lid above the hole, from where a hand can clear it away. */
  @Test
  void aFragmentThatCameOutHindersNoOther() {
    List<Exit> exits =
        exits(
            body("block", BlockWithHole.bits(), Mobility.FIXED, new Pose()),
            body("peg", BlockWithHole.PEG, Mobility.MOVABLE, Pose.at(0, 40, 0)),
            body("lid", LID, Mobility.MOVABLE, Pose.at(0, 0, 6)));
    assertEquals(List.of(2, 1), exits.stream().map(Exit::fragment).toList());
    assertTrue(exits.stream().allMatch(exit -> exit.pulled().isOut()), exits.toString());
  }

  @Test
  void aFragmentWithRoomHasMoreWaysOutThanOne() {
    List<Exit> exits =
        exits(
            body("floor", PullSearchTest.box(0, 0, 0, 16, 16, 4), Mobility.FIXED, new Pose()),
            body(
                "peg",
                PullSearchTest.box(6, 6, 4, 10, 10, 8),
                Mobility.MOVABLE,
                Pose.at(0, 40, 0)));
    assertEquals(3, exits.get(0).others().size());
    assertTrue(exits.get(0).others().stream().allMatch(way -> way.isOut()));
  }

  @Test
  void whatIsShutInIsGivenUp() {
    List<Exit> exits =
        exits(
            body("block", BlockWithHole.bits(), Mobility.FIXED, new Pose()),
            body("plug", LID, Mobility.FIXED, new Pose()),
            body("peg", BlockWithHole.PEG, Mobility.MOVABLE, Pose.at(0, 40, 0)));
    assertEquals(2, exits.get(0).fragment());
    assertFalse(exits.get(0).pulled().isOut());
    assertTrue(exits.get(0).pulled().way().isEmpty());
  }

  @Test
  void bodiesThatOverlapInTheirPlacesHaveNoWay() {
    List<Exit> exits =
        exits(
            body("block", BlockWithHole.bits(), Mobility.FIXED, new Pose()),
            body(
                "peg",
                PullSearchTest.box(5, 6, 4, 10, 10, 12),
                Mobility.MOVABLE,
                Pose.at(0, 40, 0)));
    assertEquals(1, exits.size());
    assertFalse(exits.get(0).pulled().isOut());
  }

  private static Body body(String name, BitCube bits, Mobility mobility, Pose start) {
    Body body = new Body(name, bits, BlockWithHole.GRID, mobility);
    body.setPose(start);
    return body;
  }

  private static List<Exit> exits(Body... bodies) {
    BodyScene scene = new BodyScene(new ArrayList<>(List.of(bodies)));
    List<Pose> truth = Collections.nCopies(bodies.length, new Pose());
    return Disassembly.of(scene, truth, MovableShapes.ofPoints(scene), 30);
  }
}
