(run with: --machine laser-xtz --machine-set tip.rapid=straight --param LRP=0)
O0001 (X and Y are as fast: both go 20, then X goes on alone along Y0)
G01 X50. Y20. F600.
G00 X-50. Y0 (expect alarm SINGULAR says on the axis of the work) (expect moves: none)
M30
(finally machine X50 Y20)
