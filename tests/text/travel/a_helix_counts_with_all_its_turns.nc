(run with: --machine laser3)
O1 (WCS-7)
G90 G00 X340.
G03 X340. I15. Z-5. F1000 (expect alarm OT0500 says X would go to 370)
M30
