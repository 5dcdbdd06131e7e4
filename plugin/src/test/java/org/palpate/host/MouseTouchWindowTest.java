package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.device.HapticDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.geometry.Vec3;
import org.palpate.scene.StandardView;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.ProgramWithPanel;
import org.palpate.volume.phantom.Phantom;

/** A mouse that presses on the picture of a session and takes the simulated hand over. */
class MouseTouchWindowTest {
  private static final long PATIENCE_S = 60;
  private static final long PERIOD_NANOS = 1_000_000;
  private static final Vec3 MIDDLE = new Vec3(16, 16, 16);

  /** Time in which a press must have come to rest, and a test that nothing more happens. */
  private static final long REST_NANOS = 700_000_000;

  private ProgramWithPanel program;
  private Robot robot;
  private MouseTakeover hand;
  private TouchSession session;
  private SessionView view;

  @BeforeEach
  void openSession() throws Exception {
    Assumptions.assumeTrue(
        System.getenv("XDG_CURRENT_DESKTOP") == null,
        "skipped: somebody works here, whose mouse this would move");
    program = new ProgramWithPanel();
    robot = new Robot();
    robot.setAutoWaitForIdle(true);
    ContactScene scene =
        new ContactScene(Phantom.parse("sphere:32").segments(), ContactSettings.standard());
    HapticDevice simulated = new SimulatedDevice(7, scene.handTarget(), PERIOD_NANOS);
    hand = new MouseTakeover(simulated, scene.handTarget(), PERIOD_NANOS);
    session = new TouchSession(scene, hand, SessionSettings.standard());
    ViewOptions options = ViewOptions.PLAIN.in(program.panel());
    view = new SessionView(session, scene.volume(), WorldAxes.LPS, hand, listener(), options);
    session.start();
    view.start();
    await(() -> view.firstSurfaceMillis() > 0 && session.status().frames() > 0);
  }

  @AfterEach
  void close() throws Exception {
    if (view != null) {
      session.stop();
      view.close();
      session.close();
    }
    if (program != null) {
      program.close();
    }
  }

  @Test
  void aPressTakesTheHandOverAndTouchesTheSideThatIsSeenFromEverySide() throws Exception {
    press();
    awaitContactTowards(StandardView.OBLIQUE);
    assertTrue(hand.mouse().hasJumped());
    type(KeyEvent.VK_F);
    press();
    awaitContactTowards(StandardView.FRONT);
    long freed = session.report().statistics().freed();
    type(KeyEvent.VK_B);
    press();
    awaitContactTowards(StandardView.BACK);
    assertEquals(freed + 1, session.report().statistics().freed());
  }

  @Test
  void aPressOnTheBackgroundLeavesTheHandAndTurnsTheView() throws Exception {
    Point corner = corner();
    robot.mouseMove(corner.x + 4, corner.y + 4);
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    rest();
    robot.mouseMove(corner.x + 64, corner.y + 24);
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    rest();
    assertTrue(!hand.mouse().hasJumped());
    press();
    Vec3 oblique = StandardView.OBLIQUE.towardsEye();
    await(() -> session.status().contact());
    rest();
    double cosine = outward().dot(oblique) / oblique.length();
    assertTrue(cosine > 0 && cosine < 0.97, "the view has turned before the press: " + cosine);
  }

  @Test
  void aKeyFreesThePoint() throws Exception {
    press();
    awaitContactTowards(StandardView.OBLIQUE);
    type(KeyEvent.VK_C);
    await(() -> !session.status().contact());
    rest();
    assertEquals(0, session.status().forceNewton());
  }

  private void press() {
    Point corner = corner();
    Component panel = program.panel().component();
    robot.mouseMove(corner.x + panel.getWidth() / 2, corner.y + panel.getHeight() / 2);
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    rest();
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
  }

  private void type(int key) {
    robot.keyPress(key);
    robot.keyRelease(key);
    rest();
  }

  private Point corner() {
    return program.panel().component().getLocationOnScreen();
  }

  private void awaitContactTowards(StandardView side) throws Exception {
    await(
        () -> {
          Vec3 eye = side.towardsEye();
          return session.status().contact()
              && session.status().forceNewton() > 0.1
              && outward().dot(eye) > 0.97 * eye.length();
        });
  }

  /** Returns the unit vector from the middle of the ball to the interaction point. */
  private Vec3 outward() {
    Vec3 point = view.proxyGrid();
    point.sub(MIDDLE, point);
    return point.mul(1 / point.length(), point);
  }

  private static void rest() {
    long end = System.nanoTime() + REST_NANOS;
    while (System.nanoTime() < end) {
      Thread.onSpinWait();
    }
  }

  private static void await(BooleanSupplier condition) throws Exception {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    while (!condition.getAsBoolean() && System.nanoTime() < end) {
      Thread.onSpinWait();
    }
    assertTrue(condition.getAsBoolean());
  }

  private static SessionView.Listener listener() {
    return new SessionView.Listener() {
      @Override
      public void print(String line) {
        throw new AssertionError(line);
      }

      @Override
      public void stop() {}
    };
  }
}
