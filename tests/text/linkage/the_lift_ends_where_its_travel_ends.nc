(run with: --machine arm4)
O0001 (Z of the arm is a joint of its own; the tool length does not count)
G10 L10 P1 R20.
G01 X200. Z-50. F600. (expect moves: line X200 Z-50)
G43 H1 Z-49. (expect moves: line Z-49)
Z-51. (expect alarm LIMIT says Z would stand at -51 mm)
M30
(finally machine X200 Z-29)
