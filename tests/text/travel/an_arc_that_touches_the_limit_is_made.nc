(run with: --machine laser3)
O1 (WCS-7: R30 round Y220: its top is the limit itself)
G90 G00 X-30. Y220.
G02 X30. R30. F1000 (expect moves: cw X30 Y220 @0,220 XY)
M30
