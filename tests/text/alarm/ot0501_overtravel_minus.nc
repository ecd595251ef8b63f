(run with: --param stroke_check=1)
O1 (OT0501: the other direction)
G90 G00 X-99999. (expect alarm OT0501)
M30
(finally moves: none)
