package org.palpate.platform;

import static org.palpate.platform.ImagejProbeWatch.await;
import static org.palpate.platform.ImagejProbeWatch.isAlive;

import ij.IJ;
import ij.gui.GenericDialog;
import ij.gui.MultiLineLabel;
import ij.plugin.frame.Recorder;
import java.awt.Button;
import java.awt.Checkbox;
import java.awt.Choice;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dialog;
import java.awt.EventQueue;
import java.awt.Label;
import java.awt.TextField;
import java.awt.Window;
import java.awt.event.ActionEvent;
import java.awt.event.ActionListener;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;

/** Operates and reads ImageJ's dialogs for {@link ImagejProbe}. */
final class ImagejProbeDialogs {
  private ImagejProbeDialogs() {}

  interface Filling {
    void fill(GenericDialog dialog);
  }

  static void byHand(String command, String title, Filling filling) {
    IJ.doCommand(command);
    GenericDialog dialog = awaitDialog(title);
    filling.fill(dialog);
    press(dialog, "OK");
    await("the dialog to close", () -> !dialog.isShowing());
  }

  /**
   * Waits until the recorder has written a command and forgotten it. It writes the line first and
   * forgets the command afterwards; a command started in between would be forgotten in its place.
   */
  static void awaitRecorded(Recorder recorder, String command, String text) {
    await(
        command + " in the recorder", () -> recorder.getText().contains(text) && !isAlive(command));
  }

  /** Chooses the file in Swing's file chooser. */
  static void saveAs(Path file) {
    await("the file chooser", () -> chooser() != null && isModal());
    JFileChooser chooser = chooser();
    EventQueue.invokeLater(
        () -> {
          chooser.setSelectedFile(file.toFile());
          chooser.approveSelection();
        });
  }

  private static JFileChooser chooser() {
    for (Window window : Window.getWindows()) {
      if (window instanceof JDialog dialog && window.isShowing()) {
        for (Component component : dialog.getContentPane().getComponents()) {
          if (component instanceof JFileChooser chooser) {
            return chooser;
          }
        }
      }
    }
    return null;
  }

  static void text(GenericDialog dialog, int field, String value) {
    setText((TextField) dialog.getStringFields().get(field), value);
  }

  static void number(GenericDialog dialog, int field, String value) {
    setText((TextField) dialog.getNumericFields().get(field), value);
  }

  /** Sets a text on the event thread: the peer of a field is Swing's, and paints itself there. */
  private static void setText(TextField field, String value) {
    try {
      EventQueue.invokeAndWait(() -> field.setText(value));
    } catch (InterruptedException | InvocationTargetException e) {
      throw new AssertionError(e);
    }
  }

  static void choose(GenericDialog dialog, String value) {
    ((Choice) dialog.getChoices().get(0)).select(value);
  }

  static GenericDialog awaitDialog(String title) {
    return (GenericDialog) awaitAny(title);
  }

  static Dialog awaitAny(String title) {
    await("the dialog " + title, () -> shown(title) != null && isModal());
    return shown(title);
  }

  /**
   * Whether a thread waits for a dialog's end. A dialog that is closed before, when it has hardly
   * appeared, leaves its thread waiting for ever.
   */
  private static boolean isModal() {
    return Thread.getAllStackTraces().values().stream()
        .anyMatch(
            frames ->
                isIn(frames, "java.awt.Dialog", "show")
                    && isIn(frames, "java.awt.WaitDispatchSupport", "enter"));
  }

  private static boolean isIn(StackTraceElement[] frames, String type, String method) {
    return Arrays.stream(frames)
        .anyMatch(
            frame -> frame.getClassName().equals(type) && frame.getMethodName().equals(method));
  }

  private static Dialog shown(String title) {
    for (Window window : Window.getWindows()) {
      if (window instanceof Dialog dialog
          && window.isShowing()
          && dialog.getTitle().equals(title)) {
        return dialog;
      }
    }
    return null;
  }

  static List<String> texts(Container container) {
    List<String> texts = new ArrayList<>();
    for (Component component : container.getComponents()) {
      if (component instanceof Label label) {
        texts.add(label.getText());
      } else if (component instanceof TextField field) {
        texts.add("[" + field.getText() + "]");
      } else if (component instanceof Checkbox box) {
        texts.add("(" + box.getState() + ") " + box.getLabel());
      } else if (component instanceof Choice choice) {
        texts.add("<" + choice.getSelectedItem() + ">");
      } else if (component instanceof Button button) {
        texts.add("{" + button.getLabel() + "}");
      } else if (component instanceof MultiLineLabel label) {
        texts.add(lines(label));
      } else if (component instanceof JLabel label) {
        texts.add(label.getText());
      } else if (component instanceof Container inner) {
        texts.addAll(texts(inner));
      }
    }
    return texts;
  }

  /** Reads the text of ImageJ's label, which has no accessor. */
  private static String lines(MultiLineLabel label) {
    try {
      Field lines = MultiLineLabel.class.getDeclaredField("lines");
      lines.setAccessible(true);
      return String.join("\n", (String[]) lines.get(label));
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }

  static void press(Container container, String label) {
    if (!pressed(container, label)) {
      throw new IllegalStateException("no button " + label + " in " + texts(container));
    }
  }

  private static boolean pressed(Container container, String label) {
    for (Component component : container.getComponents()) {
      if (component instanceof Button button && button.getLabel().strip().equals(label)) {
        ActionEvent event = new ActionEvent(button, ActionEvent.ACTION_PERFORMED, label);
        for (ActionListener listener : button.getActionListeners()) {
          EventQueue.invokeLater(() -> listener.actionPerformed(event));
        }
        return true;
      }
      if (component instanceof Container inner && pressed(inner, label)) {
        return true;
      }
    }
    return false;
  }
}
