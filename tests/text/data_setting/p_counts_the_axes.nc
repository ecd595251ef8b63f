O1 (section 7.4: the machine has three axes)
G10 L50
N5440 P3 R0.5
N5440 P4 R0.5 (expect alarm PS0231 at P4)
G11
M30
(finally assumed: none)
