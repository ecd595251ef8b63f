(run with: --machine laser-xtz --machine-set tip.rapid=straight --param LRP=1)
O0001 (the straight way has the axis beside it)
G01 X50. Y20. F600.
G00 X-50. Y0 (expect moves: rapid X-50 Y0)
M30
(finally machine X-50 Y0)
