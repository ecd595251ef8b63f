(run with: --machine laser3)
O1 (WCS-7: both ends lie within Y250, the top at Y263.19)
G90 G00 X-30. Y240. (expect moves: rapid X-30 Y240)
G02 X30. R31. F1000 (expect alarm OT0500 says Y would go to 263.1897)
M30
