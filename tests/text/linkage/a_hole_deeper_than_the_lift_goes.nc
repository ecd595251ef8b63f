(run with: --machine arm4)
O0001 (the tool stands over the hole when its depth is refused)
G01 X200. Y50. F600.
G99 G81 X150. Y50. Z-60. R2. F100. (expect alarm LIMIT says Z would stand at -60 mm) (expect moves: rapid X150; rapid Z2)
G80
M30
(finally machine X150 Y50 Z2)
