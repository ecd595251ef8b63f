O1 (ARG-1: there are ten sets)
G65 P2 I1. I2. I3. I4. I5. I6. I7. I8. I9. I10. I11. (expect alarm PS1095)
M30
O2
M99
