(run with: --machine laser3)
O1 (WCS-7)
G00 Z-51. (expect alarm OT0501 says Z would go to -51, the limit is -50)
M30
(finally moves: none)
