O1 (PS0190: a mill of three axes has no fourth)
G96 S100 P4 (expect alarm PS0190 at P4)
M30
