print 1;
print
print
' (finally printed 1 ||)
