/** How true the forces of the solvers are, on surfaces known by formula. */
package org.palpate.accuracy;
