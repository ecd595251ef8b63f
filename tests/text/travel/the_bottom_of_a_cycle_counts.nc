(run with: --machine laser3)
O1 (WCS-7)
G90 G81 X10. Z-55. R5. F100 (expect alarm OT0501 says Z would go to -55)
M30
