(run with: --machine laser-xtz)
O0001 (the work would have to turn before)
G01 X50. Y20. F600.
X0 Y0 (expect moves: line X0 Y0)
X10. Y10. (expect alarm SINGULAR)
M30
(finally machine X0 Y0)
