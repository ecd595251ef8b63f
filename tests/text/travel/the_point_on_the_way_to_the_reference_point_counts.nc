(run with: --machine laser3)
O1 (WCS-7, REF-1)
G90 G28 X400. Y10. (expect alarm OT0500 says X would go to 400)
M30
(finally moves: none)
