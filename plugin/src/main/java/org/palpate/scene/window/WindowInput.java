package org.palpate.scene.window;

import com.jogamp.newt.event.KeyAdapter;
import com.jogamp.newt.event.KeyEvent;
import com.jogamp.newt.event.KeyListener;
import com.jogamp.newt.event.MouseAdapter;
import com.jogamp.newt.event.MouseEvent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.IntSupplier;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneState;
import org.palpate.scene.StandardView;
import org.palpate.scene.Stereo;

/**
 * The actions of mouse and keys.
 *
 * <p>Left drag touches if the mouse is the device, otherwise it turns the scene. Right drag turns;
 * middle drag, or left drag with Shift, moves. The wheel zooms or, while touching, changes the
 * pressure.
 */
public final class WindowInput extends MouseAdapter {
  private static final double RADIANS_PER_HEIGHT = Math.PI;
  private static final double ZOOM_STEP = 0.9;
  private static final double MIN_PRESS = 0.002;
  private static final double MAX_PRESS = 0.2;

  private final SceneModel model;
  private final IntSupplier width;
  private final IntSupplier height;
  private final Map<Character, Key> keys = new LinkedHashMap<>();
  private final AtomicReference<double[]> requestedPick = new AtomicReference<>();
  private volatile Optional<PointerListener> pointer = Optional.empty();
  private volatile double pressFraction = 0.02;
  private boolean helpShown;
  private boolean touching;
  private int lastX;
  private int lastY;

  /** The action of a key; {@code repeats} means that it repeats while the key is held down. */
  private record Key(String help, Runnable action, boolean repeats) {}

  WindowInput(SceneModel model, IntSupplier width, IntSupplier height) {
    this.model = model;
    this.width = width;
    this.height = height;
    addViewKeys();
  }

  private void addViewKeys() {
    onKey('f', "front view", () -> look(StandardView.FRONT));
    onKey('b', "back view", () -> look(StandardView.BACK));
    onKey('l', "left view", () -> look(StandardView.LEFT));
    onKey('r', "right view", () -> look(StandardView.RIGHT));
    onKey('t', "view from the head", () -> look(StandardView.HEAD));
    onKey('u', "view from the foot", () -> look(StandardView.FOOT));
    onKey('o', "oblique view, fits all", () -> look(StandardView.OBLIQUE));
    onKey('d', "dark or light", () -> model.changeLook(SceneState.Look::withOtherTheme));
    onKey(
        '3',
        "stereo: off, anaglyph, side by side",
        () -> model.changeLook(WindowInput::nextStereo));
    onKey('h', "this help", this::toggleHelp);
  }

  private static SceneState.Look nextStereo(SceneState.Look look) {
    return look.with(
        switch (look.stereo()) {
          case OFF -> Stereo.ANAGLYPH;
          case ANAGLYPH -> Stereo.SIDE_BY_SIDE;
          default -> Stereo.OFF;
        });
  }

  private void look(StandardView view) {
    model.look(view, (double) Math.max(1, width.getAsInt()) / Math.max(1, height.getAsInt()));
  }

  /**
   * Assigns an action to a key. {@code help} describes it in a few words. Any thread, before the
   * window is shown.
   */
  public void onKey(char key, String help, Runnable action) {
    synchronized (keys) {
      keys.put(key, new Key(help, action, false));
    }
  }

  /** Assigns an action that repeats while the key is held down. */
  public void onHeldKey(char key, String help, Runnable action) {
    synchronized (keys) {
      keys.put(key, new Key(help, action, true));
    }
  }

  /** Makes the mouse the device. */
  public void setPointer(PointerListener listener) {
    pointer = Optional.of(listener);
  }

  /** Runs the action of a key, if it has one. */
  void press(char key) {
    press(key, false);
  }

  private void press(char key, boolean isRepeat) {
    Key found;
    synchronized (keys) {
      found = keys.get(Character.toLowerCase(key));
    }
    if (found != null && (found.repeats || !isRepeat)) {
      found.action.run();
    }
  }

  private void toggleHelp() {
    helpShown = !helpShown;
    model.setHelp(helpShown ? helpLines() : List.of());
  }

  private List<String> helpLines() {
    List<String> lines = new ArrayList<>();
    lines.add(
        pointer.isPresent()
            ? "left drag: touch     right drag: turn     middle drag: move"
            : "drag: turn     middle or Shift drag: move");
    lines.add(
        pointer.isPresent()
            ? "wheel: nearer, or press harder while touching"
            : "wheel: nearer or further");
    synchronized (keys) {
      keys.forEach((key, action) -> lines.add(name(key) + "   " + action.help));
    }
    return lines;
  }

  private static String name(char key) {
    return key == KeyEvent.VK_ESCAPE ? "Esc" : key == ' ' ? "Space" : String.valueOf(key);
  }

  /** Returns the listener for NEWT's key events. */
  KeyListener keys() {
    return new KeyAdapter() {
      @Override
      public void keyPressed(KeyEvent event) {
        if (event.getKeyCode() == KeyEvent.VK_ESCAPE) {
          press((char) KeyEvent.VK_ESCAPE);
        } else if (event.isPrintableKey()) {
          press(event.getKeyChar(), event.isAutoRepeat());
        }
      }
    };
  }

  @Override
  public void mousePressed(MouseEvent event) {
    lastX = event.getX();
    lastY = event.getY();
    touching =
        pointer.isPresent() && event.getButton() == MouseEvent.BUTTON1 && !event.isShiftDown();
    touch(event);
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    double dx = (event.getX() - lastX) / (double) Math.max(1, height.getAsInt());
    double dy = (event.getY() - lastY) / (double) Math.max(1, height.getAsInt());
    lastX = event.getX();
    lastY = event.getY();
    if (touching) {
      touch(event);
    } else if (event.isButtonDown(MouseEvent.BUTTON2) || event.isShiftDown()) {
      model.moveCamera(camera -> camera.pan(dx, -dy), true);
    } else {
      model.moveCamera(
          camera -> camera.orbit(dx * RADIANS_PER_HEIGHT, -dy * RADIANS_PER_HEIGHT), true);
    }
  }

  @Override
  public void mouseReleased(MouseEvent event) {
    boolean wasMoving = !touching;
    touching = false;
    if (wasMoving) {
      model.moveCamera(camera -> camera, false);
    }
  }

  @Override
  public void mouseWheelMoved(MouseEvent event) {
    double steps = event.getRotation()[1];
    if (touching) {
      double pressed = pressFraction * Math.pow(ZOOM_STEP, -steps);
      pressFraction = Math.max(MIN_PRESS, Math.min(MAX_PRESS, pressed));
      touch(event);
    } else {
      model.moveCamera(camera -> camera.zoom(Math.pow(ZOOM_STEP, steps)), false);
    }
  }

  private void touch(MouseEvent event) {
    if (touching) {
      requestedPick.set(new double[] {event.getX(), event.getY()});
      model.requestRedraw();
    }
  }

  /** Finds the point under the mouse if one was requested. Called by the drawing thread. */
  void pick(Function<double[], Optional<Vec3>> finder) {
    double[] at = requestedPick.getAndSet(null);
    if (at != null) {
      finder.apply(at).ifPresent(this::movePointer);
    }
  }

  private void movePointer(Vec3 onSurface) {
    SceneState state = model.state();
    Vec3 pressed = state.camera().back().mul(-pressFraction * state.radiusMm(), new Vec3());
    Vec3 world = model.axes().toSceneOrBack(onSurface.add(pressed, pressed), pressed);
    pointer.ifPresent(listener -> listener.moved(world));
  }
}
