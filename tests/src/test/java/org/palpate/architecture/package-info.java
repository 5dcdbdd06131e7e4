/**
 * Who may use whom, held by tests over the classes of every module.
 *
 * <p>Uses everything, as classes to look at. No thread, no units.
 */
package org.palpate.architecture;
