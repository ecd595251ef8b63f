(run with: --param stroke_check=1)
O1 (OT0500, WCS-7: a hundred metres are beyond any mill)
G90 G00 X99999. (expect alarm OT0500)
M30
(finally moves: none)
