(run with: --machine laser3 --skip-at Z=-10)
O1 (WCS-7: the probe would stop at Z-10, but nobody knows that before)
G90 G31 Z-60. F100 (expect alarm OT0501 says Z would go to -60)
M30
