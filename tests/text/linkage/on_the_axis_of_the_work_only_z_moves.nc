(run with: --machine laser-xtz)
O0001 (the angle is not determined, and stays)
G01 X50. Y0 F600.
X0 (expect moves: line X0 Y0)
Z2. (expect moves: line X0 Y0 Z2)
Y-20. (expect alarm SINGULAR)
M30
(finally machine X0 Y0 Z2)
