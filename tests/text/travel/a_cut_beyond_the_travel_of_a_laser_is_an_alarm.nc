(run with: --machine laser3)
O1 (WCS-7: the table goes to X350)
G21 G90 M03 S500
G01 X350. F6000 (expect moves: line X350)
M03 S800 X5000. (expect alarm OT0500 says X would go to 5000, the limit is 350)
M30
(finally machine X350)
(finally moves: line X350)
