#line 1 "/etc/passwd"
int first = nothing_of_that_name;
