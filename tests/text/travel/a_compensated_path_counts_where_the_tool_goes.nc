(run with: --machine laser3 --set #13001=10)
O1 (WCS-7: X345 is programmed, X355 would be made)
G90 G00 X300. Y-20.
G42 D1 G01 X345. Y0 F1000 (expect alarm OT0500 says X would go to 355)
Y100.
G40 X300.
M30
